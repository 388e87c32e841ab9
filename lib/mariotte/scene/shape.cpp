#include "mariotte/scene/shape.hpp"

#include <array>

#include "mariotte/core/error.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/radius.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 4> microbody_shapes{"sphere", "dumbbell", "rod", "custom"};
constexpr std::array<std::string_view, 9> body_keys{
    "diameter", "material", "shape", "radius", "length_ratio", "density", "mass", "inertia", "tips"};
constexpr std::array<std::string_view, 2> tip_keys{"centre", "radius"};

Field required(const Source& source, const Field& table, std::string_view key) {
  const auto field = find(table, key);
  if (!field) reject(source, table, fault::missing, "'" + std::string(key) + "' is missing");
  return *field;
}

double positive(const Source& source, const Field& field, const Dimension& dimension) {
  return number(source, field, dimension, Domain::positive);
}

/// Of the body, or of its material.
std::optional<double> find_density(Source& source, const Field& body,
                                   const std::optional<Material>& material) {
  if (const auto field = find(body, "density")) return read_density(source, *field);
  return material ? material->density : std::nullopt;
}

/// A key that belongs to other shapes.
void expect_none(const Source& source, const Field& body, std::string_view shape,
                 std::initializer_list<const char*> foreign) {
  for (const auto* key : foreign)
    if (const auto field = find(body, key))
      reject(source, *field, fault::misplaced, "does not go with shape '" + std::string(shape) + "'");
}

model::Tip read_tip(Source& source, const Field& table, const std::optional<double>& common) {
  expect_keys(source, table, tip_keys);
  model::Tip tip{.centre = read_vector(source, required(source, table, "centre"), dimension::length),
                 .radius = common.value_or(0)};
  if (const auto own = find(table, "radius"))
    tip.radius = read_radius(source, *own, large_microbody);
  else if (!common)
    reject(source, table, fault::missing, "'radius' is missing");
  return tip;
}

model::RigidBody read_custom(Source& source, const Field& body) {
  expect_none(source, body, "custom", {"length_ratio"});
  model::RigidBody custom;
  custom.mass = positive(source, required(source, body, "mass"), dimension::mass);
  const auto inertia = required(source, body, "inertia");
  custom.inertia = read_vector(source, inertia, dimension::inertia);
  const auto radius = find_radius(source, body, large_microbody);
  const auto tips = required(source, body, "tips");
  if (!tips.node->array()) reject(source, tips, fault::wrong_type, "expected an array of tables");
  const auto count = static_cast<Index>(tips.node->array()->size());
  if (count < 1 || count > 2) reject(source, tips, fault::wrong_length, "a body has one or two tips");
  for (Index i = 0; i < count; ++i) custom.tips.push_back(read_tip(source, element(tips, i), radius));
  try {
    model::validate(custom);
  } catch (const InvalidParameter& error) {
    reject(source, inertia, error.fault, error.what());
  }
  return custom;
}

model::RigidBody read_as(Source& source, const Field& body, std::string_view shape,
                         const std::optional<double>& density) {
  if (shape == "custom") return read_custom(source, body);
  expect_none(source, body, shape, {"mass", "inertia", "tips"});
  if (shape == "sphere") expect_none(source, body, shape, {"length_ratio"});
  double radius = 0, ratio = 0;
  ErrorList errors;
  errors.attempt([&] {
    const auto found = find_radius(source, body, large_microbody);
    radius = found ? *found : read_radius(source, required(source, body, "radius"), large_microbody);
  });
  errors.attempt([&] {
    if (shape == "sphere") return;
    ratio = number(source, required(source, body, "length_ratio"), dimension::none, Domain::not_negative);
  });
  errors.attempt([&] {
    if (!density) reject(source, body, fault::missing, "'density' is missing, and no material gives it");
  });
  errors.raise();
  if (shape == "sphere") return model::sphere(radius, *density);
  if (shape == "dumbbell") return model::dumbbell(radius, ratio, *density);
  return model::rod(radius, ratio, *density);
}

/// By the keys that it has.
std::string_view guess_shape(const Field& body) {
  return find(body, "tips") ? "custom" : find(body, "length_ratio") ? "rod" : "sphere";
}

model::RigidBody read_rigid_body(Source& source, const Field& body, const std::optional<double>& density) {
  std::string_view shape;
  ErrorList errors;
  if (!errors.attempt([&] {
        shape = microbody_shapes[choice(source, required(source, body, "shape"), "shape", microbody_shapes)];
      }))
    errors.attempt_on_a_guess([&] { read_as(source, body, guess_shape(body), density); });
  errors.raise();
  return read_as(source, body, shape, density);
}

}  // namespace

Shape read_shape(Source& source, const Field& body) {
  Shape shape;
  ErrorList errors;
  errors.attempt([&] { expect_keys(source, body, body_keys); });
  const bool known = errors.attempt([&] {
    if (const auto field = find(body, "material")) shape.material = read_material(source, *field);
    shape.density = find_density(source, body, shape.material);
  });
  errors.attempt([&] { shape.body = read_rigid_body(source, body, known ? shape.density : 1); });
  errors.raise();
  return shape;
}

}  // namespace mariotte::scene
