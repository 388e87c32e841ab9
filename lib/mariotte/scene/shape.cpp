#include "mariotte/scene/shape.hpp"

#include <array>

#include "mariotte/core/error.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 4> shapes{"sphere", "dumbbell", "rod", "custom"};
constexpr std::array<std::string_view, 7> keys{"shape", "radius",  "length_ratio", "density",
                                               "mass",  "inertia", "tips"};
constexpr std::array<std::string_view, 2> tip_keys{"centre", "radius"};
constexpr Dimension inertia_dimension{.kg = 1, .m = 2};

Field required(const Source& source, const Field& table, std::string_view key) {
  const auto field = find(table, key);
  if (!field) reject(source, table, fault::missing, "'" + std::string(key) + "' is missing");
  return *field;
}

double positive(const Source& source, const Field& field, const Dimension& dimension) {
  return number(source, field, dimension, Domain::positive);
}

double read_radius(Source& source, const Field& field) {
  const double radius = positive(source, field, dimension::length);
  if (radius > 1e-3) warn(source, field, "more than 1 mm is no microbody (a bare number is in metres)");
  return radius;
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
    tip.radius = read_radius(source, *own);
  else if (!common)
    reject(source, table, fault::missing, "'radius' is missing");
  return tip;
}

Shape read_custom(Source& source, const Field& body) {
  expect_none(source, body, "custom", {"length_ratio"});
  Shape shape;
  shape.body.mass = positive(source, required(source, body, "mass"), dimension::mass);
  const auto inertia = required(source, body, "inertia");
  shape.body.inertia = read_vector(source, inertia, inertia_dimension);
  std::optional<double> radius;
  if (const auto field = find(body, "radius")) radius = read_radius(source, *field);
  const auto tips = required(source, body, "tips");
  if (!tips.node->array()) reject(source, tips, fault::wrong_type, "expected an array of tables");
  const auto count = static_cast<Index>(tips.node->array()->size());
  if (count < 1 || count > 2) reject(source, tips, fault::wrong_length, "a body has one or two tips");
  for (Index i = 0; i < count; ++i) shape.body.tips.push_back(read_tip(source, element(tips, i), radius));
  if (const auto density = find(body, "density"))
    shape.density = positive(source, *density, dimension::density);
  try {
    model::validate(shape.body);
  } catch (const InvalidParameter& error) {
    reject(source, inertia, error.fault, error.what());
  }
  return shape;
}

}  // namespace

Shape read_shape(Source& source, const Field& body) {
  expect_keys(source, body, keys);
  const auto shape = shapes[choice(source, required(source, body, "shape"), "shape", shapes)];
  if (shape == "custom") return read_custom(source, body);
  expect_none(source, body, shape, {"mass", "inertia", "tips"});
  if (shape == "sphere") expect_none(source, body, shape, {"length_ratio"});
  const double radius = read_radius(source, required(source, body, "radius"));
  const double density = positive(source, required(source, body, "density"), dimension::density);
  if (shape == "sphere") return {model::sphere(radius, density), density};
  const double ratio =
      number(source, required(source, body, "length_ratio"), dimension::none, Domain::not_negative);
  if (shape == "dumbbell") return {model::dumbbell(radius, ratio, density), density};
  return {model::rod(radius, ratio, density), density};
}

}  // namespace mariotte::scene
