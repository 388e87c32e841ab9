#include "mariotte/scene/bodies_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mariotte/core/error.hpp"
#include "mariotte/model/microbody/rigid_body.hpp"
#include "mariotte/scene/angle.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/radius.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 5> body_shapes{"ball", "rod", "dumbbell", "block", "custom"};
constexpr std::array<std::string_view, 16> one_body_keys{
    "name",     "shape", "radius", "diameter",   "mass",    "density", "material", "position",
    "velocity", "spin",  "angle",  "quaternion", "inertia", "spheres", "length",   "size"};
constexpr std::array<std::string_view, 2> sphere_keys{"centre", "radius"};

/// One body as it is read: its own keys go before those of all.
struct Reader {
  Source& source;
  const Field& table;
  const Field& bodies;
  int dimension;
  std::string name;

  std::optional<Field> own(std::string_view key) const { return find(table, key); }
  std::optional<Field> any(std::string_view key) const {
    const auto field = own(key);
    return field ? field : find(bodies, key);
  }
  Field required(std::string_view key) const {
    if (const auto field = any(key)) return *field;
    reject(source, table, fault::missing, name + ": '" + std::string(key) + "' is missing");
  }
  double positive(const Field& field, const Dimension& unit) const {
    return number(source, field, unit, Domain::positive);
  }

  /// 'radius', or half of 'diameter'; the body's own goes before that of all.
  std::optional<double> radius() const {
    const auto own_radius = find_radius(source, table);
    return own_radius ? own_radius : find_radius(source, bodies);
  }
  std::optional<double> density(const std::optional<Material>& material) const {
    if (const auto field = any("density")) return read_density(source, *field);
    return material ? material->density : std::nullopt;
  }
  /// Given, or of this volume.
  double mass(double volume, const std::optional<Material>& material) const {
    if (const auto field = any("mass")) return positive(*field, dimension::mass);
    const auto filling = density(material);
    if (!filling) reject(source, table, fault::no_mass, name + " needs a mass, or a density and its size");
    return volume * *filling;
  }
  void expect_none(std::string_view shape, std::initializer_list<const char*> foreign) const {
    for (const auto* key : foreign)
      if (const auto field = own(key))
        reject(source, *field, fault::misplaced, "does not go with shape '" + std::string(shape) + "'");
  }
};

double ball_volume(double radius) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

void read_ball(const Reader& read, const std::optional<Material>& material, model::Body& body) {
  ErrorList errors;
  std::optional<double> radius;
  errors.attempt([&] { read.expect_none("ball", {"spheres", "length", "size"}); });
  errors.attempt([&] {
    radius = read.radius();
    if (!radius) read.required("radius");
  });
  errors.attempt([&] { body.mass = read.mass(ball_volume(radius.value_or(0)), material); });
  errors.raise();
  const double moment = 0.4 * body.mass * *radius * *radius;
  body.inertia = {moment, moment, moment};
  body.spheres = {{{}, *radius}};
}

/// With hemispherical ends whose centres are `length` apart, along the first axis of the body.
void read_capped(const Reader& read, bool filled, const std::optional<Material>& material,
                 model::Body& body) {
  read.expect_none(filled ? "rod" : "dumbbell", {"spheres", "size"});
  const auto radius = read.radius();
  if (!radius) read.required("radius");
  const double length = read.positive(read.required("length"), dimension::length);
  const auto solid =
      filled ? model::rod(*radius, length / *radius, 1) : model::dumbbell(*radius, length / *radius, 1);
  body.mass = read.mass(solid.mass, material);
  body.inertia = (body.mass / solid.mass) * solid.inertia;
  for (const auto& tip : solid.tips) body.spheres.push_back({tip.centre, tip.radius});
}

/// It touches by its corners, which are points, or rounded with a radius.
void read_block(const Reader& read, const std::optional<Material>& material, model::Body& body) {
  read.expect_none("block", {"spheres", "length"});
  const auto field = read.required("size");
  const auto size = numbers(read.source, field, dimension::length, Domain::positive);
  const bool flat = read.dimension == 2;
  if (!(size.size() == 3 || (flat && size.size() == 2)))
    reject(read.source, field, fault::wrong_length,
           flat ? "expected two values, or three" : "expected three values");
  const bool has_depth = size.size() == 3;
  if (!has_depth && !read.any("mass"))
    reject(read.source, field, fault::no_mass, read.name + " needs a mass, or a third size");
  const double a = size[0], b = size[1], c = has_depth ? size[2] : 0;
  body.mass = read.mass(a * b * c, material);
  body.inertia = (body.mass / 12) * Vector3{b * b + c * c, a * a + c * c, a * a + b * b};
  const double round =
      find_radius(read.source, read.table, large_body, Domain::not_negative).value_or(0);  // its own alone
  const double least = flat ? std::min(a, b) : std::min({a, b, c});
  if (round > least / 2)
    reject(read.source, field, fault::out_of_range, "is smaller than the rounding of its corners");
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        if (!flat || z > 0)
          body.spheres.push_back(
              {{x * (a / 2 - round), y * (b / 2 - round), flat ? 0 : z * (c / 2 - round)}, round});
}

void read_custom(const Reader& read, model::Body& body) {
  read.expect_none("custom", {"length", "size"});
  body.mass = read.mass(0, std::nullopt);
  read.required("inertia");
  const auto list = read.required("spheres");
  if (!list.node->array() || list.node->array()->empty())
    reject(read.source, list, fault::wrong_type, "expected an array of tables, each with a centre");
  const auto common = read.radius();
  for (Index i = 0; i < std::ssize(*list.node->array()); ++i) {
    const auto table = element(list, i);
    expect_keys(read.source, table, sphere_keys);
    const auto centre = find(table, "centre"), radius = find(table, "radius");
    if (!radius && !common) reject(read.source, table, fault::missing, "'radius' is missing (0 for a point)");
    body.spheres.push_back(
        {centre ? read_coordinates(read.source, *centre, dimension::length, read.dimension) : Vector3{},
         radius ? number(read.source, *radius, dimension::length, Domain::not_negative) : *common});
  }
}

/// One number in the plane; in space one for all axes, or three.
void read_inertia(const Reader& read, model::Body& body) {
  const auto field = read.own("inertia");
  if (!field) return;
  if (!field->node->array()) {
    const double moment = read.positive(*field, dimension::inertia);
    body.inertia = {moment, moment, moment};
    return;
  }
  if (read.dimension == 2) reject(read.source, *field, fault::wrong_type, "expected one number in the plane");
  body.inertia = read_vector(read.source, *field, dimension::inertia);
}

void read_attitude(const Reader& read, model::Body& body) {
  const auto angle = read.own("angle"), quaternion = read.own("quaternion");
  if (angle && read.dimension == 3)
    reject(read.source, *angle, fault::misplaced, "is for the plane; bodies in space have a quaternion");
  if (quaternion && read.dimension == 2)
    reject(read.source, *quaternion, fault::misplaced, "is for space; bodies in the plane have an angle");
  if (angle) body.angle = number(read.source, *angle, dimension::none, Domain::finite);
  if (const auto hint = hint_at_radians(body.angle); !hint.empty())
    warn(read.source, *angle, "more than a full turn" + hint);
  if (!quaternion) return;
  const auto q = numbers(read.source, *quaternion, dimension::none, Domain::finite);
  expect_length(read.source, *quaternion, q.size(), 4);
  const Quaternion all{q[0], q[1], q[2], q[3]};
  if (!(std::hypot(std::hypot(all.w, all.x), std::hypot(all.y, all.z)) > 0))
    reject(read.source, *quaternion, fault::out_of_range, "must not be zero");
  body.attitude = normalized(all);
}

void read_spin(const Reader& read, model::Body& body) {
  const auto spin = read.own("spin");
  if (!spin) return;
  if (read.dimension == 2)
    body.spin.e3 = number(read.source, *spin, dimension::rate, Domain::finite);
  else
    body.spin = read_vector(read.source, *spin, dimension::rate);
}

void read_motion(const Reader& read, model::Body& body, ErrorList& errors) {
  const auto vector = [&](const Field& field, const Dimension& dimension) {
    return read_coordinates(read.source, field, dimension, read.dimension);
  };
  errors.attempt([&] { body.position = vector(read.required("position"), dimension::length); });
  if (const auto field = read.own("velocity"))
    errors.attempt([&] { body.velocity = vector(*field, dimension::velocity); });
  errors.attempt([&] { read_spin(read, body); });
}

void read_shape(const Reader& read, const std::optional<Material>& material, model::Body& body) {
  const auto shape = read.any("shape");
  const auto kind = shape ? body_shapes[choice(read.source, *shape, "shape", body_shapes)] : body_shapes[0];
  if (kind == "ball")
    read_ball(read, material, body);
  else if (kind == "block")
    read_block(read, material, body);
  else if (kind == "custom")
    read_custom(read, body);
  else
    read_capped(read, kind == "rod", material, body);
}

}  // namespace

Vector3 read_coordinates(const Source& source, const Field& field, const Dimension& dimension, int count) {
  auto values = numbers(source, field, dimension, Domain::finite);
  expect_length(source, field, values.size(), static_cast<std::size_t>(count));
  values.resize(3, 0.0);
  return {values[0], values[1], values[2]};
}

ShapedBody read_shaped_body(Source& source, const Field& table, const Field& bodies, int dimension, Index i) {
  if (!table.node->table()) expect_keys(source, table, one_body_keys);  // says that it is no table
  ShapedBody shaped;
  auto& body = shaped.body;
  Reader read{source, table, bodies, dimension, "body " + std::to_string(i + 1)};
  ErrorList errors;
  errors.attempt([&] { expect_keys(source, table, one_body_keys); });
  errors.attempt([&] {
    if (const auto field = read.own("name")) read.name = body.name = text(source, *field);
  });
  const bool known = errors.attempt([&] {
    if (const auto field = read.any("material")) shaped.ball.material = read_material(source, *field);
  });
  if (known) errors.attempt([&] { read_shape(read, shaped.ball.material, body); });
  errors.attempt([&] { read_inertia(read, body); });
  errors.attempt([&] { read_attitude(read, body); });
  read_motion(read, body, errors);
  errors.raise();
  shaped.ball.mass = body.mass;
  return shaped;
}

}  // namespace mariotte::scene
