#include "mariotte/scene/bodies_reader.hpp"

#include <map>

#include "mariotte/core/error.hpp"
#include "mariotte/scene/bodies_names.hpp"
#include "mariotte/scene/bodies_pairs.hpp"
#include "mariotte/scene/bodies_shapes.hpp"
#include "mariotte/scene/error_list.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 12> own_keys{"dimension", "gravity",  "material", "shape",
                                                    "radius",    "diameter", "mass",     "density",
                                                    "touching",  "body",     "plane",    "contact"};
constexpr std::array<std::string_view, 5> plane_keys{"name", "point", "normal", "velocity", "material"};

Field list_of(const Source& source, const Field& bodies, const char* key) {
  const auto list = find(bodies, key);
  if (!list) reject(source, bodies, fault::missing, "there is no [[bodies." + std::string(key) + "]]");
  if (!list->node->array() || list->node->array()->empty())
    reject(source, *list, fault::wrong_type, "write [[bodies." + std::string(key) + "]], with two brackets");
  return *list;
}

/// As many as the first body's position has.
int guess_dimension(const Source& source, const Field& bodies) {
  const auto first = element(list_of(source, bodies, "body"), 0);
  const auto position = first.node->table() ? find(first, "position") : std::nullopt;
  return position && position->node->array() && position->node->array()->size() == 2 ? 2 : 3;
}

int read_dimension(const Source& source, const Field& bodies) {
  if (const auto field = find(bodies, "dimension")) return static_cast<int>(whole(source, *field, 2, 3));
  return guess_dimension(source, bodies);
}

Vector3 read_normal(const Source& source, const Field& table, int dimension) {
  const auto field = find(table, "normal");
  if (!field) reject(source, table, fault::missing, "'normal' is missing");
  const auto normal = read_coordinates(source, *field, dimension::none, dimension);
  const double length = norm(normal);
  if (!(length > 0)) reject(source, *field, fault::out_of_range, "must not be zero");
  return (1 / length) * normal;
}

model::Plane read_plane(const Source& source, const Field& table, int dimension) {
  model::Plane plane;
  ErrorList errors;
  const auto part = [&](const char* key, auto&& read) {
    if (const auto field = find(table, key)) errors.attempt([&] { read(*field); });
  };
  errors.attempt([&] { expect_keys(source, table, plane_keys); });
  errors.attempt([&] { plane.normal = read_normal(source, table, dimension); });
  part("name", [&](const Field& field) { plane.name = text(source, field); });
  part("point", [&](const Field& field) {
    plane.point = read_coordinates(source, field, dimension::length, dimension);
  });
  part("velocity", [&](const Field& field) {
    plane.velocity = read_coordinates(source, field, dimension::velocity, dimension);
  });
  errors.raise();
  return plane;
}

void read_planes(Source& source, const Field& bodies, model::Bodies& model, Touchables& touchables) {
  if (!find(bodies, "plane")) return;
  const auto list = list_of(source, bodies, "plane");
  ErrorList errors;
  for (Index i = 0; i < std::ssize(*list.node->array()); ++i) {
    const auto table = element(list, i);
    errors.attempt_one_of_many([&] { model.plane.push_back(read_plane(source, table, model.dimension)); });
    Ball plane{.mass = infinity, .radius = infinity, .material = {}, .velocity = {}};
    auto material = find(table, "material");
    if (!material) material = find(bodies, "material");
    if (material) errors.attempt_one_of_many([&] { plane.material = read_material(source, *material); });
    touchables.plane.push_back(plane);
  }
  errors.raise();
}

void read_list(Source& source, const Field& bodies, model::Bodies& model, Touchables& touchables) {
  const auto list = list_of(source, bodies, "body");
  ErrorList errors;
  for (Index i = 0; i < std::ssize(*list.node->array()); ++i)
    errors.attempt_one_of_many([&] {
      auto shaped = read_shaped_body(source, element(list, i), bodies, model.dimension, i);
      model.body.push_back(std::move(shaped.body));
      touchables.body.push_back(std::move(shaped.ball));
    });
  errors.raise();
}

/// A name means one thing: no other body or plane is called so, by name or by number.
void expect_own_names(const Source& source, const Field& bodies, const model::Bodies& model) {
  std::map<std::string_view, const Called*> known;
  const auto all = called(model);
  for (const auto& one : all) {
    const auto* other = known.emplace(one.word, &one).first->second;
    if (other->features == one.features) continue;
    const auto& given = one.is_given ? one : *other;
    const auto& feature = given.features[0];
    const auto list = find(bodies, feature.is_plane() ? "plane" : "body");
    reject(source, *find(element(*list, feature.owner), "name"), fault::contradiction,
           "another body or plane is called '" + given.word + "', too");
  }
}

/// Gravity, bodies and planes.
Touchables read_touchables(Source& source, const Field& bodies, model::Bodies& model) {
  Touchables touchables;
  ErrorList errors;
  if (const auto field = find(bodies, "gravity"))
    errors.attempt(
        [&] { model.gravity = read_coordinates(source, *field, dimension::acceleration, model.dimension); });
  errors.attempt([&] { read_list(source, bodies, model, touchables); });
  errors.attempt([&] { read_planes(source, bodies, model, touchables); });
  errors.raise();
  expect_own_names(source, bodies, model);
  return touchables;
}

/// A ball, or a block of which no corner hits it, passes through a face.
void warn_of_faces(Source& source, const Field& bodies) {
  const auto list = find(bodies, "body");
  const Index count = std::ssize(*list->node->array());
  for (Index i = 0; count > 1 && i < count; ++i) {
    const auto shape = find(element(*list, i), "shape");
    if (shape && text(source, *shape) == "block")
      return warn(source, *shape,
                  "blocks touch by their corners only: other bodies pass through their faces");
  }
}

/// Why nothing can touch.
std::string untouchable(const Field& bodies) {
  if (find(bodies, "law") && find(bodies, "stiffness"))
    return "nothing can touch: there is no plane, and bodies are one, or have points only, which never meet "
           "(a 'radius' makes corners round)";
  return "nothing can touch: [bodies] says no law with a stiffness or materials, and no [[bodies.contact]] "
         "does";
}

}  // namespace

ResolvedBodies read_bodies(Source& source, const Field& bodies) {
  auto keys = pair_keys;
  keys.insert(keys.end(), own_keys.begin(), own_keys.end());
  if (!bodies.node->table()) expect_keys(source, bodies, keys);  // says that it is no table
  ResolvedBodies resolved;
  auto& model = resolved.bodies;
  ErrorList errors;
  errors.attempt([&] { expect_keys(source, bodies, keys); });
  Touchables touchables;
  if (errors.attempt([&] { model.dimension = read_dimension(source, bodies); }))
    errors.attempt([&] { touchables = read_touchables(source, bodies, model); });
  else
    errors.attempt_on_a_guess([&] {
      model.dimension = guess_dimension(source, bodies);
      read_touchables(source, bodies, model);
    });
  if (!errors.empty()) errors.attempt([&] { check_pairs(source, bodies); });
  errors.raise();
  resolved.touching = read_pairs(source, bodies, touchables, model);
  if (model.contact.empty()) reject(source, bodies, fault::impossible, untouchable(bodies));
  warn_of_faces(source, bodies);
  return resolved;
}

}  // namespace mariotte::scene
