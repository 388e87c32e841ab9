#include "mariotte/scene/bodies_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/core/nearest.hpp"
#include "mariotte/scene/bodies_names.hpp"
#include "mariotte/scene/contact_law.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/touching.hpp"

namespace mariotte::scene {

using model::Feature;
using model::TangentialLaw;

namespace {

constexpr auto all_pair_keys =
    law_keys_and(std::array<std::string_view, 4>{"tangential", "friction", "share", "tangential_stiffness"});
constexpr std::array<std::string_view, 4> tangential_names{"none", "rigid", "spring", "mindlin"};

/// A pair and the table that speaks of it; none of those that [bodies] alone speaks of.
struct Pair {
  Feature a, b;
  std::optional<Field> table = {};
};

/// Spheres of a body, or one of them, or a plane, by name or number.
std::vector<Feature> find_touching(const Source& source, const Field& field, const model::Bodies& model) {
  if (std::holds_alternative<std::int64_t>(field.node->value))
    return all_spheres(model, whole(source, field, 1, std::ssize(model.body)) - 1);
  const auto word = text(source, field);
  const auto all = called(model);
  std::vector<std::string_view> known;
  for (const auto& one : all) {
    if (one.word == word) return one.features;
    if (one.is_whole) known.push_back(one.word);
  }
  reject(source, field, fault::leads_nowhere,
         "no body or plane has the name '" + word + "'" + suggestion(word, known));
}

double radius_of(const model::Bodies& model, const Feature& feature) {
  return feature.is_plane() ? infinity : model.body[feature.owner].spheres[feature.sphere].radius;
}

bool can_touch(const model::Bodies& model, const Feature& a, const Feature& b) {
  return a.is_plane() || (a.owner != b.owner && radius_of(model, a) + radius_of(model, b) > 0);
}

/// The pairs of one table; a plane goes first.
void add_pairs(const Source& source, const Field& table, const model::Bodies& model,
               std::vector<Pair>& pairs) {
  const auto between = find(table, "between");
  if (!between || !between->node->array())
    reject(source, between ? *between : table, fault::missing,
           "'between' is missing: the two that touch, as in between = [\"cue\", 2]");
  expect_length(source, *between, between->node->array()->size(), 2);
  auto left = find_touching(source, element(*between, 0), model),
       right = find_touching(source, element(*between, 1), model);
  if (right[0].is_plane()) std::swap(left, right);
  if (right[0].is_plane()) reject(source, *between, fault::impossible, "two planes do not touch");
  if (!left[0].is_plane() && left[0].owner == right[0].owner)
    reject(source, *between, fault::impossible, "a body does not touch itself");
  const auto meets = [&](const Feature& a, const Feature& b) { return can_touch(model, a, b); };
  if (std::none_of(left.begin(), left.end(), [&](const Feature& a) {
        return std::any_of(right.begin(), right.end(), [&](const Feature& b) { return meets(a, b); });
      }))
    reject(source, *between, fault::impossible,
           "corners of both are points, which never meet: give one of them a 'radius'");
  for (const auto& a : left)
    for (const auto& b : right) {
      if (!meets(a, b)) continue;
      const auto same = [&](const Pair& one) {
        return (one.a == a && one.b == b) || (one.a == b && one.b == a);
      };
      if (std::any_of(pairs.begin(), pairs.end(), same))
        reject(source, *between, fault::contradiction,
               name_of(model, a) + " and " + name_of(model, b) + " have been said before");
      pairs.push_back({a, b, table});
    }
}

/// All that the tables leave out.
void add_others(const model::Bodies& model, std::vector<Pair>& pairs) {
  const auto named = pairs;
  const auto add = [&](const Feature& a, const Feature& b) {
    const auto same = [&](const Pair& one) {
      return (one.a == a && one.b == b) || (one.a == b && one.b == a);
    };
    if (can_touch(model, a, b) && std::none_of(named.begin(), named.end(), same)) pairs.push_back({a, b});
  };
  std::vector<Feature> spheres;
  for (Index i = 0; i < std::ssize(model.body); ++i)
    for (Index k = 0; k < std::ssize(model.body[i].spheres); ++k) spheres.push_back({i, k});
  for (Index i = 0; i < std::ssize(model.plane); ++i)
    for (const auto& sphere : spheres) add({i, -1}, sphere);
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.size(); ++j) add(spheres[i], spheres[j]);
}

/// A law that [bodies] says for all, with what it takes: a stiffness, or materials of everything.
bool has_common_law(const Field& bodies, const Touchables& touchables) {
  if (!find(bodies, "law")) return false;
  if (find(bodies, "stiffness") || find(bodies, "loading_stiffness") || find(bodies, "effective_modulus") ||
      find(bodies, "table"))
    return true;
  const auto known = [](const Ball& one) { return one.material && elastic(*one.material).has_value(); };
  return std::all_of(touchables.body.begin(), touchables.body.end(), known) &&
         std::all_of(touchables.plane.begin(), touchables.plane.end(), known);
}

/// κ = 8 G* √R* with 1/G* = Σ (2−ν)/G; a rigid partner has no term [Mindlin 1949].
std::optional<double> mindlin_stiffness(const Ball& a, const Ball& b) {
  double compliance = 0, curvature = 0;
  for (const auto* ball : {&a, &b}) {
    const auto one = elastic(ball->material.value_or(Material{}));
    if (!one || !ball->radius || !(*ball->radius > 0)) return {};
    compliance += (2 - one->poisson) * 2 * (1 + one->poisson) / one->young;
    curvature += 1 / *ball->radius;
  }
  if (!(compliance > 0) || !(curvature > 0)) return {};
  return 8 / (compliance * std::sqrt(curvature));
}

model::Tangential read_tangential(const Source& source, const LawTables& tables, Index contact, const Ball& a,
                                  const Ball& b) {
  const auto law = tables.find_for(contact, "tangential"), friction = tables.find_for(contact, "friction");
  model::Tangential tangential;
  if (!law && friction && number(source, *friction, dimension::none, Domain::not_negative) > 0)
    reject(source, *friction, fault::missing,
           "'tangential' is missing beside it: none, rigid, spring or mindlin");
  if (!law) return tangential;
  tangential.law = static_cast<TangentialLaw>(choice(source, *law, "tangential law", tangential_names));
  if (tangential.law == TangentialLaw::none) return tangential;
  if (!friction) reject(source, *law, fault::missing, "'friction' is missing beside it");
  tangential.friction = number(source, *friction, dimension::none, Domain::not_negative);
  if (!tangential.has_spring()) return tangential;
  const bool grows = tangential.law == TangentialLaw::mindlin;
  if (const auto field = tables.find_for(contact, "tangential_stiffness")) {
    tangential.stiffness = number(source, *field, dimension::stiffness(grows ? 1.5 : 1), Domain::positive);
    return tangential;
  }
  const auto stiffness = grows ? mindlin_stiffness(a, b) : std::nullopt;
  if (!stiffness)
    reject(source, *law, fault::no_stiffness,
           "contact " + std::to_string(contact + 1) + " needs 'tangential_stiffness'" +
               (grows ? ", or radius, young and poisson of both its bodies" : " [N/m]"));
  tangential.stiffness = *stiffness;
  return tangential;
}

double read_share(const Source& source, const Field& field) {
  const double share = number(source, field, dimension::none, Domain::not_negative);
  if (share > 1) reject(source, field, fault::out_of_range, "must not be above 1");
  return share;
}

/// Speed at which the centres of two spheres, or of one and a plane, approach; not negative.
double approach(const model::Bodies& model, const Pair& pair) {
  const auto velocity = [&](const Feature& feature) {
    return feature.is_plane() ? model.plane[feature.owner].velocity : model.body[feature.owner].velocity;
  };
  return norm(velocity(pair.b) - velocity(pair.a));
}

/// Its law, friction, share, and whether its table says that it touches.
model::BodyContact read_contact(const Source& source, const LawTables& tables, Index c, const Pair& pair,
                                const BallPair& balls, Encounters& encounters) {
  model::BodyContact contact{.a = pair.a, .b = pair.b, .law = {}};
  ErrorList errors;
  errors.attempt([&] { contact.law = read_law(source, tables, c, balls, encounters); });
  errors.attempt([&] { contact.tangential = read_tangential(source, tables, c, *balls.left, *balls.right); });
  if (const auto field = tables.find_for(c, "share"))
    errors.attempt([&] { contact.share = read_share(source, *field); });
  if (const auto field = pair.table ? find(*pair.table, "touching") : std::nullopt)
    errors.attempt([&] { contact.touching = boolean(source, *field); });
  errors.raise();
  return contact;
}

/// Closes a contact whose gap is rounding; refuses overlap.
void close_within(const Source& source, const Field& place, double touching, const model::Bodies& model,
                  model::BodyContact& contact) {
  contact.touching = contact.touching || std::abs(start_gap(model, contact)) <= touching;
  if (start_gap(model, contact) < 0)
    reject(source, place, fault::overlap,
           name_of(model, contact.a) + " and " + name_of(model, contact.b) + " overlap at the start");
}

std::vector<Field> contact_tables(const Source& source, const Field& bodies) {
  const auto list = find(bodies, "contact");
  if (!list) return {};
  if (!list->node->array())
    reject(source, *list, fault::wrong_type, "write [[bodies.contact]], with two brackets");
  std::vector<Field> tables;
  for (Index i = 0; i < std::ssize(*list->node->array()); ++i) tables.push_back(element(*list, i));
  return tables;
}

void expect_contact_keys(const Source& source, const Field& table) {
  auto keys = pair_keys;
  keys.insert(keys.end(), {"between", "touching"});
  expect_keys(source, table, keys);
}

void expect_one_value(const Source& source, const Field& bodies) {
  expect_no_lists(source, bodies, all_pair_keys, "for all pairs; [[bodies.contact]] says what one has else");
}

}  // namespace

const std::vector<std::string_view> pair_keys(all_pair_keys.begin(), all_pair_keys.end());

std::vector<impact::Touching> read_pairs(Source& source, const Field& bodies, const Touchables& touchables,
                                         model::Bodies& model) {
  std::vector<Pair> pairs;
  ErrorList errors;
  for (const auto& table : contact_tables(source, bodies))
    errors.attempt([&] {
      expect_contact_keys(source, table);
      add_pairs(source, table, model, pairs);
    });
  errors.attempt([&] { errors.empty() ? expect_one_value(source, bodies) : check_pairs(source, bodies); });
  errors.raise();
  model.named = std::ssize(pairs);
  if (has_common_law(bodies, touchables)) add_others(model, pairs);

  LawTables tables{bodies, {}};
  for (Index c = 0; c < model.named; ++c) tables.numbered.emplace(c, *pairs[c].table);
  const auto ball = [&](const Feature& feature) {
    Ball one = feature.is_plane() ? touchables.plane[feature.owner] : touchables.body[feature.owner];
    one.radius = radius_of(model, feature);
    return one;
  };
  Encounters encounters{
      .reduced_mass = [&](Index c) { return reduced_mass(*ball(pairs[c].a).mass, *ball(pairs[c].b).mass); },
      .speed = 0};
  for (const auto& pair : pairs) encounters.speed = std::max(encounters.speed, approach(model, pair));
  const auto rounding = find(bodies, "touching");
  const double touching = rounding ? number(source, *rounding, dimension::length, Domain::not_negative) : 0;
  std::vector<impact::Touching> known;
  for (Index c = 0; c < std::ssize(pairs); ++c)
    errors.attempt_one_of_many([&] {
      const auto& pair = pairs[c];
      const Ball a = ball(pair.a), b = ball(pair.b);
      auto contact = read_contact(source, tables, c, pair, {&a, &b}, encounters);
      close_within(source, tables.place_of(c), touching, model, contact);
      model.contact.push_back(std::move(contact));
      known.push_back(scene::touching(a, b));
    });
  errors.raise();
  return known;
}

void check_pairs(const Source& source, const Field& bodies) {
  const LawTables tables{bodies, contact_tables(source, bodies)};
  ErrorList errors;
  for (const auto& table : tables.contacts) errors.attempt([&] { expect_contact_keys(source, table); });
  if (errors.attempt([&] { expect_one_value(source, bodies); })) {
    if (find(bodies, "law")) errors.attempt([&] { check_laws(source, {bodies, {}}, 1); });
    errors.attempt([&] { check_laws(source, tables, std::ssize(tables.contacts)); });
  }
  errors.raise();
}

}  // namespace mariotte::scene
