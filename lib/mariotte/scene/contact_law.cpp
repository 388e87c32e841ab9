#include "mariotte/scene/contact_law.hpp"

#include <array>
#include <cmath>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/law_table.hpp"

namespace mariotte::scene {
namespace {

using contact::NamedLaw;

constexpr double usual_exponent = 1.5;  ///< Hertz's, unless the law or the scene has another

const NamedLaw& read_name(const Source& source, const Field& field) {
  static const auto names = [] {
    std::vector<std::string_view> list;
    for (const auto& law : contact::named_laws) list.push_back(law.name);
    return list;
  }();
  return contact::named_laws[choice(source, field, "law", names)];
}

std::string quoted(const NamedLaw& law) {
  return "law '" + std::string(law.name) + "'";
}

bool may_choose_exponent(const NamedLaw& law) {
  return law.find("exponent") != nullptr;
}

double read_exponent(const Source& source, const LawTables& tables, Index contact, const NamedLaw& law) {
  const double own = law.exponent.value_or(usual_exponent);
  const auto field = tables.find_for(contact, "exponent");
  if (!field || !law.find("stiffness")) return own;
  const double exponent = number(source, *field, dimension::none, Domain::finite);
  if (exponent < 1) reject(source, *field, fault::out_of_range, "must be at least 1");
  if (!may_choose_exponent(law) && exponent != own)
    reject(source, *field, fault::misplaced, quoted(law) + " has its own exponent (viscoelastic has any)");
  return exponent;
}

/// The relaxation time A of a law f + A df/dt, as a damping.
std::optional<double> read_relaxation(const Source& source, const LawTables& tables, Index contact,
                                      const NamedLaw& law, const contact::LawNumbers& numbers) {
  const auto field = tables.find_for(contact, "relaxation_time");
  if (!field || !law.relaxation) return std::nullopt;
  if (const auto damping = tables.find_for(contact, "damping"))
    reject(source, *field, fault::contradiction, "'damping' is given, too; give one of them");
  return law.relaxation(numbers.exponent) * numbers.stiffness *
         number(source, *field, dimension::time, Domain::not_negative);
}

/// A contact of its own law may have got it from all.
[[noreturn]] void refuse_damping(const Source& source, const LawTables& tables, Index contact,
                                 const Field& field, const NamedLaw& law) {
  const auto& own = tables.place_of(contact);
  const bool is_of_all = &own != &tables.whole && find(own, "law") && !find(own, "damping");
  const auto whose = is_of_all ? " of contact " + std::to_string(contact + 1) : "";
  const auto remedy = is_of_all ? "give that contact damping = 0, or take " : "take ";
  reject(source, field, fault::misplaced,
         quoted(law) + whose + " has no damping; " + remedy + contact::names_of_damped_laws());
}

/// The damping itself; a restitution takes its place.
double read_damping(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                    const NamedLaw& law, const contact::LawNumbers& numbers) {
  if (const auto damping = read_relaxation(source, tables, contact, law, numbers)) return *damping;
  const auto field = tables.find_for(contact, "damping");
  const auto* key = law.damping();
  if (!field && key && !key->may_be_missing)
    reject(source, law_field, fault::missing, quoted(law) + " needs a damping, or a restitution");
  if (!field) return 0;
  const auto unit = key ? key->dimension : dimension::damping;
  const double damping = number(source, *field, unit(numbers.exponent), Domain::not_negative);
  if (!key && damping != 0) refuse_damping(source, tables, contact, *field, law);
  return damping;
}

/// The restitution of a contact, unless its own table says a damping instead.
std::optional<Field> find_restitution(const Source& source, const LawTables& tables, Index contact) {
  const auto restitution = tables.find_for(contact, "restitution");
  const auto damping = tables.find_for(contact, "damping");
  if (!restitution || !damping) return restitution;
  const auto& own = tables.place_of(contact);
  const bool own_restitution = find(own, "restitution").has_value(),
             own_damping = find(own, "damping").has_value();
  if (own_restitution == own_damping)
    reject(source, *restitution, fault::contradiction, "'damping' is given, too; give one of them");
  return own_restitution ? restitution : std::nullopt;
}

Encounter read_encounter(const Source& source, const LawTables& tables, Index contact, const Field& field,
                         const Encounters& encounters, bool by_speed) {
  Encounter encounter{.reduced_mass = encounters.reduced_mass(contact), .speed = encounters.speed};
  if (const auto at = tables.find_for(contact, "at"))
    encounter.speed = number(source, *at, dimension::velocity, Domain::positive);
  if (!(encounter.speed > 0) && by_speed)
    reject(source, field, fault::missing,
           "needs 'at', the speed of approach it is meant for, since no balls approach at the start");
  if (!(encounter.speed > 0)) encounter.speed = 1;
  return encounter;
}

/// The damping that gives a restitution.
double solve_damping(const Source& source, const LawTables& tables, Index contact, const Field& field,
                     const LawChoice& law, const contact::LawNumbers& numbers, Encounters& encounters) {
  const double e = number(source, field, dimension::none, Domain::positive);
  if (e > 1) reject(source, field, fault::out_of_range, "must not be above 1");
  if (e == 1) return 0;
  if (!law.law.damping())
    reject(source, field, fault::misplaced,
           quoted(law.law) + " has no damping; take " + contact::names_of_damped_laws());
  const auto encounter =
      read_encounter(source, tables, contact, field, encounters, depends_on_speed(law.law, numbers.exponent));
  try {
    const auto damping = encounters.solver.damping(law, numbers, e, encounter);
    if (!damping) reject(source, field, fault::out_of_range, "is more than is left without damping");
    if (!(*damping > 0) || !std::isfinite(*damping))
      reject(source, field, fault::out_of_range, "has no damping that double precision can carry");
    return *damping;
  } catch (const InvalidParameter& error) {
    reject(source, field, error.fault, error.what());
  }
}

std::string name_of(Index contact) {
  return "contact " + std::to_string(contact + 1);
}

/// Elastic spheres that touch.
struct ElasticPair {
  contact::Elasticity left, right;
  double left_radius, right_radius;
};

/// What the two balls of a contact say; a key of the law would have said what is `needed`.
ElasticPair elastic_pair(const Source& source, const Field& law_field, Index contact, const BallPair& pair,
                         std::string_view needed) {
  const auto [a, b] = pair;
  const auto elastic_of = [](const Ball* ball) {
    return ball ? elastic(ball->material.value_or(Material{})) : std::nullopt;
  };
  const auto elastic_a = elastic_of(a), elastic_b = elastic_of(b);
  if (!elastic_a || !elastic_b || !a->radius || !b->radius)
    reject(source, law_field, fault::no_stiffness,
           name_of(contact) + " needs " + std::string(needed) +
               ", or radius, young and poisson of both its balls");
  return {*elastic_a, *elastic_b, *a->radius, *b->radius};
}

/// From the materials and radii of the two balls [N/m^1.5].
double material_stiffness(const Source& source, const Field& law_field, Index contact, const BallPair& pair) {
  const auto spheres = elastic_pair(source, law_field, contact, pair, "a stiffness");
  if (spheres.left_radius == 0 || spheres.right_radius == 0)
    reject(source, law_field, fault::no_stiffness,
           name_of(contact) +
               " is that of a point, as the corner of a block: it needs a stiffness, or the body a 'radius'");
  const double stiffness =
      contact::hertz_stiffness(spheres.left, spheres.left_radius, spheres.right, spheres.right_radius);
  if (!(stiffness > 0) || !std::isfinite(stiffness))
    reject(source, law_field, fault::no_stiffness,
           name_of(contact) + " has no finite stiffness: two rigid bodies, or two planes");
  return stiffness;
}

double read_stiffness(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                      double exponent, const BallPair& pair) {
  if (const auto field = tables.find_for(contact, "stiffness"))
    return number(source, *field, dimension::stiffness(exponent), Domain::positive);
  if (exponent != usual_exponent)
    reject(source, law_field, fault::no_stiffness,
           name_of(contact) + " needs a stiffness (materials give it for the exponent 1.5 only)");
  return material_stiffness(source, law_field, contact, pair);
}

double pair_modulus(const Source& source, const Field& law_field, Index contact, const BallPair& pair) {
  const auto spheres = elastic_pair(source, law_field, contact, pair, "'effective_modulus'");
  return contact::effective_modulus(spheres.left, spheres.right);
}
double pair_radius(const Source& source, const Field& law_field, Index contact, const BallPair& pair) {
  const auto [a, b] = pair;
  if (!a || !b || !a->radius || !b->radius)
    reject(source, law_field, fault::no_stiffness,
           name_of(contact) + " needs 'effective_radius', or the radius of both its balls");
  return contact::effective_radius(*a->radius, *b->radius);
}

/// A number of the law that its materials and radii do not give, or that goes before them.
double read_number(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                   const contact::LawKey& key, double exponent, const BallPair& pair) {
  const auto domain = key.may_be_missing ? Domain::not_negative : Domain::positive;
  if (const auto field = tables.find_for(contact, key.key))
    return number(source, *field, key.dimension(exponent), domain);
  if (key.may_be_missing) return 0;
  const bool is_modulus = key.key == "effective_modulus";
  if (!is_modulus && key.key != "effective_radius")
    reject(source, law_field, fault::missing, name_of(contact) + " needs '" + std::string(key.key) + "'");
  const double value = is_modulus ? pair_modulus(source, law_field, contact, pair)
                                  : pair_radius(source, law_field, contact, pair);
  if (!(value > 0) || !std::isfinite(value))
    reject(source, law_field, fault::no_stiffness,
           name_of(contact) + " has no finite " + std::string(key.key) + ": two rigid bodies, or two planes");
  return value;
}

/// Every number but a damping.
void read_numbers(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                  const NamedLaw& law, const BallPair& pair, contact::LawNumbers& numbers) {
  numbers.exponent = read_exponent(source, tables, contact, law);
  ErrorList errors;
  for (const auto& key : law.keys) {
    if (key.key == "damping" || key.key == "exponent") continue;
    errors.attempt([&] {
      numbers.*key.number =
          key.key == "stiffness"
              ? read_stiffness(source, tables, contact, law_field, numbers.exponent, pair)
              : read_number(source, tables, contact, law_field, key, numbers.exponent, pair);
    });
  }
  errors.raise();
  if (!law.has_table) return;
  const auto table = tables.find_for(contact, "table");
  if (!table) reject(source, law_field, fault::missing, name_of(contact) + " needs 'table', a CSV file");
  numbers.points = read_law_table(source, *table);
}

/// Whether the force is cut off where it would pull, which is usual.
bool read_uncut(const Source& source, const LawTables& tables, Index contact, const NamedLaw& law) {
  const auto field = tables.find_for(contact, "separation");
  if (!field) return false;
  constexpr std::array<std::string_view, 2> ends{"force", "indentation"};
  const bool uncut = choice(source, *field, "separation", ends) == 1;
  if (uncut && (!law.damping() || law.find("work_of_adhesion")))
    reject(source, *field, fault::misplaced, quoted(law) + " has an end of its own");
  return uncut;
}

/// A table of one contact says nothing that its law does not know; what is said of all may be for others.
void expect_own_keys(const Source& source, const LawTables& tables, Index contact, const NamedLaw& law) {
  const auto& own = tables.place_of(contact);
  constexpr std::array<std::string_view, 8> common{"law", "exponent",   "damping",         "restitution",
                                                   "at",  "separation", "relaxation_time", "stiffness"};
  for (const auto key : law_keys) {
    const bool known = law.find(key) || std::find(common.begin(), common.end(), key) != common.end();
    const bool misses = key == "stiffness"         ? !law.find(key)
                        : key == "relaxation_time" ? !law.relaxation
                        : key == "table"           ? !law.has_table
                                                   : !known;
    if (const auto field = find(own, key); field && misses && &own != &tables.whole)
      reject(source, *field, fault::misplaced, quoted(law) + " has no " + std::string(key));
  }
}

void expect_use_of_at(const Source& source, const LawTables& tables, Index contact) {
  if (const auto at = tables.find_for(contact, "at"); at && !tables.find_for(contact, "restitution"))
    reject(source, *at, fault::misplaced, "has no effect without 'restitution'");
}

}  // namespace

contact::Law read_law(const Source& source, const LawTables& tables, Index contact, const BallPair& pair,
                      Encounters& encounters) try {
  const auto field = tables.find_for(contact, "law");
  if (!field)
    reject(source, tables.place_of(contact), fault::missing,
           "'law' is missing (" + contact::names_of_laws() + ")");
  const auto& law = read_name(source, *field);
  ErrorList errors;
  errors.attempt([&] { expect_own_keys(source, tables, contact, law); });
  errors.attempt([&] { expect_use_of_at(source, tables, contact); });
  contact::LawNumbers numbers;
  LawChoice choice{law};
  const bool known =
      errors.attempt([&] { read_numbers(source, tables, contact, *field, law, pair, numbers); });
  errors.attempt([&] { choice.uncut = read_uncut(source, tables, contact, law); });
  errors.attempt([&] {
    const auto restitution = find_restitution(source, tables, contact);
    if (!restitution)
      numbers.damping = read_damping(source, tables, contact, *field, law, numbers);
    else if (known)
      numbers.damping = solve_damping(source, tables, contact, *restitution, choice, numbers, encounters);
  });
  errors.raise();
  return choice.make(numbers);
} catch (const InvalidParameter& error) {
  reject(source, tables.place_of(contact), error.fault, error.what());
}

void expect_no_lists(const Source& source, const Field& table, std::span<const std::string_view> keys,
                     const std::string& why) {
  ErrorList errors;
  for (const auto key : keys)
    if (const auto field = find(table, key); field && field->node->array())
      errors.attempt([&] { reject(source, *field, fault::misplaced, "must be one value " + why); });
  errors.raise();
}

void check_laws(const Source& source, const LawTables& tables, Index count) {
  const Material material{.young = 1, .poisson = 0.3, .density = 1, .yield_strength = {}};
  const Ball sphere{.mass = 1, .radius = 1, .material = material, .velocity = {}};
  Encounters encounters{.reduced_mass = [](Index) { return 1.0; }, .speed = 1};
  ErrorList errors;
  for (Index j = 0; j < count; ++j)
    errors.attempt_one_of_many([&] { read_law(source, tables, j, {&sphere, &sphere}, encounters); });
  errors.raise();
}

}  // namespace mariotte::scene
