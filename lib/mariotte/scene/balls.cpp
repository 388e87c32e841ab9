#include "mariotte/scene/balls.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/radius.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 6> override_keys{"number",   "mass",     "radius",
                                                        "diameter", "material", "velocity"};

double read_mass(Source& source, const Field& field) {
  return number(source, field, dimension::mass, Domain::positive_or_infinite);
}

double read_ball_radius(Source& source, const Field& field) {
  return read_radius(source, field, large_body, Domain::positive_or_infinite);
}
double read_ball_diameter(Source& source, const Field& field) {
  return read_diameter(source, field, large_body, Domain::positive_or_infinite);
}

double read_velocity(Source& source, const Field& field) {
  return number(source, field, dimension::velocity, Domain::finite);
}

/// Calls visit(key, member, reader) for every key a ball can have.
template <class Visit>
void each_key(Visit visit) {
  visit("mass", &Ball::mass, read_mass);
  visit("radius", &Ball::radius, read_ball_radius);
  visit("diameter", &Ball::radius, read_ball_diameter);
  visit("material", &Ball::material, read_material);
  visit("velocity", &Ball::velocity, read_velocity);
}

/// One value for all, or an array.
void read_column(Source& source, const Field& field, Index cell, std::span<Ball> balls, auto member,
                 auto read) {
  if (!field.node->array()) {
    const auto value = read(source, field);
    for (auto& ball : balls) ball.*member = value;
    return;
  }
  ErrorList errors;
  for (Index i = 0; i < cell; ++i)
    errors.attempt_one_of_many([&] {
      const auto value = read(source, element(field, i));
      for (Index k = i; k < std::ssize(balls); k += cell) balls[k].*member = value;
    });
  errors.raise();
}

/// Rejects an array of the wrong length, and what its values have wrong then.
void expect_column(Source& source, const Field& array, auto expect_length, auto read) {
  ErrorList errors;
  if (errors.attempt(expect_length)) return;
  for (Index i = 0; i < std::ssize(*array.node->array()); ++i)
    errors.attempt_one_of_many([&] { read(source, element(array, i)); });
  errors.raise();
}

/// Radii get smaller, or larger, from one ball, or cell, to the next.
void taper(Source& source, const Field& chain, const Layout& layout, std::span<Ball> balls) {
  const auto field = find(chain, "taper");
  if (!field) return;
  const double ratio = number(source, *field, dimension::none, Domain::positive);
  if (const auto mass = find(chain, "mass"))
    reject(source, *mass, fault::contradiction, "does not taper; radius and density give the masses");
  if (!find(chain, "radius") && !find(chain, "diameter"))
    reject(source, *field, fault::missing, "needs a radius, that of the first ball");
  const Index cell = find(chain, "repeat") ? layout.cell : 1;
  for (Index i = 0; i < layout.listed; ++i)
    if (balls[i].radius) *balls[i].radius *= std::pow(ratio, i / cell);
}

void read_columns(Source& source, const Field& chain, const Layout& layout, std::span<Ball> balls) {
  ErrorList errors;
  each_key([&](const char* key, auto member, auto read) {
    const auto field = find(chain, key);
    if (field)
      errors.attempt([&] {
        const bool repeats = key != std::string_view("velocity");
        if (field->node->array())
          expect_column(
              source, *field, [&] { (repeats ? expect_per_cell : expect_per_ball)(source, *field, layout); },
              read);
        read_column(source, *field, repeats ? layout.cell : layout.listed, balls, member, read);
      });
  });
  errors.attempt([&] { expect_one_size(source, chain); });
  errors.raise();
}

/// The ball a [[chain.ball]] table is about, from 0.
Index numbered(const Source& source, const Field& table, const Layout& layout, std::vector<bool>& seen) {
  const auto field = find(table, "number");
  if (!field)
    reject(source, table, fault::missing, "'number' is missing (which ball is this about, counted from 1)");
  const Index i = whole(source, *field, 1, layout.balls()) - 1;
  if ((layout.left && i == 0) || (layout.right && i == layout.balls() - 1))
    reject(source, *field, fault::misplaced,
           "ball " + std::to_string(i + 1) + " is a wall; only 'wall_material' describes it");
  if (seen[i])
    reject(source, *field, fault::contradiction, "ball " + std::to_string(i + 1) + " was given before");
  seen[i] = true;
  return i;
}

/// A table of one ball; what it says is read whatever ball it is about.
void read_override(Source& source, const Field& table, const Layout& layout, std::vector<bool>& seen,
                   std::vector<Ball>& balls) {
  Ball unknown, *ball = &unknown;
  ErrorList errors;
  errors.attempt([&] { expect_keys(source, table, override_keys); });
  errors.attempt([&] { ball = &balls[numbered(source, table, layout, seen)]; });
  errors.attempt([&] { read_properties(source, table, *ball); });
  if (const auto field = find(table, "velocity"))
    errors.attempt([&] { ball->velocity = read_velocity(source, *field); });
  errors.raise();
}

void read_overrides(Source& source, const Field& list, const Layout& layout, std::vector<Ball>& balls) {
  if (!list.node->array()) reject(source, list, fault::wrong_type, "write [[chain.ball]], with two brackets");
  std::vector<bool> seen(balls.size());
  ErrorList errors;
  for (Index i = 0; i < static_cast<Index>(list.node->array()->size()); ++i)
    errors.attempt_one_of_many([&] { read_override(source, element(list, i), layout, seen, balls); });
  errors.raise();
}

/// Walls are of wall_material, else of the chain's one material; else, if empty, of their neighbour's.
std::optional<Material> common_wall_material(Source& source, const Field& chain, const Layout& layout) {
  if (const auto own = find(chain, "wall_material")) {
    if (!layout.left && !layout.right)
      reject(source, *own, fault::misplaced, "there is no wall ('wall' makes one)");
    return read_material(source, *own);
  }
  const auto common = find(chain, "material");
  if (!common || common->node->array()) return {};
  Source silent = source;  // what there is to warn of was said when the balls were read
  return read_material(silent, *common);
}

void add_walls(Source& source, const Field& chain, const Layout& layout, std::vector<Ball>& balls) {
  const auto common = common_wall_material(source, chain, layout);
  const auto wall = [&](const Ball& neighbour) {
    return Ball{infinity, infinity, common ? common : neighbour.material, {}};
  };
  if (layout.left) balls.front() = wall(balls[1]);
  if (layout.right) balls.back() = wall(balls[balls.size() - 2]);
}

}  // namespace

void read_properties(Source& source, const Field& table, Ball& ball) {
  ErrorList errors;
  errors.attempt([&] { expect_one_size(source, table); });
  each_key([&](std::string_view key, auto member, auto read) {
    const auto field = key == "velocity" ? std::nullopt : find(table, key);
    if (field) errors.attempt([&] { ball.*member = read(source, *field); });
  });
  errors.raise();
}

double solid_sphere(const Source& source, const Field& table, const Ball& ball, Index i) {
  const auto name = "ball " + std::to_string(i + 1);
  if (!ball.radius || !ball.material || !ball.material->density)
    reject(source, table, fault::no_mass, name + " needs a mass, or a radius and a material with a density");
  const double radius = *ball.radius;
  const double mass = 4.0 / 3.0 * std::numbers::pi * *ball.material->density * radius * radius * radius;
  if (!(mass > 0) || !std::isfinite(mass))
    reject(source, table, fault::no_mass,
           name + " has no finite positive mass by its radius and density; give its mass");
  return mass;
}

std::vector<Ball> read_balls(Source& source, const Field& chain, const Layout& layout) {
  std::vector<Ball> balls(layout.balls());
  const auto listed = std::span(balls).subspan(layout.left ? 1 : 0, layout.listed);
  ErrorList errors;
  errors.attempt([&] { read_columns(source, chain, layout, listed); });
  errors.attempt([&] { taper(source, chain, layout, listed); });
  if (const auto list = find(chain, "ball"))
    errors.attempt([&] { read_overrides(source, *list, layout, balls); });
  errors.attempt([&] { add_walls(source, chain, layout, balls); });
  errors.raise();
  for (Index i = 0; i < layout.balls(); ++i)
    if (!balls[i].mass) balls[i].mass = solid_sphere(source, chain, balls[i], i);
  return balls;
}

}  // namespace mariotte::scene
