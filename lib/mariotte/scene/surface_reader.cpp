#include "mariotte/scene/surface_reader.hpp"

#include <array>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/restitution.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 14> surface_keys{"material",
                                                        "restitution",
                                                        "at",
                                                        "law",
                                                        "stiffness",
                                                        "work_of_adhesion",
                                                        "zeta_hertz",
                                                        "damping_hertz",
                                                        "zeta_adhesion",
                                                        "damping_adhesion",
                                                        "friction",
                                                        "hertz_prefactor",
                                                        "adhesion_prefactor",
                                                        "lever"};
constexpr std::array<std::string_view, 1> laws{"brach-dunn"};
constexpr std::array<std::string_view, 2> levers{"radius", "indented"};
constexpr Dimension adhesion_dimension{.kg = 1, .s = -2};
constexpr Dimension damping_dimension{.m = -1, .s = 1};

double positive(const Source& source, const Field& table, const char* key, const Dimension& dimension) {
  const auto field = find(table, key);
  if (!field) reject(source, table, fault::missing, "'" + std::string(key) + "' is missing");
  return number(source, *field, dimension, Domain::positive);
}

/// A damping coefficient, either itself or by its ζ; `formula(ζ, prefactor)` needs what may be missing.
template <class Formula>
double read_damping(const Source& source, const Field& surface, const std::string& name, double prefactor,
                    const contact::Surface& material, const std::optional<double>& density,
                    Formula&& formula) {
  const auto own = find(surface, "damping_" + name), zeta = find(surface, "zeta_" + name);
  if (own && zeta)
    reject(source, *zeta, fault::contradiction, "'damping_" + name + "' is given, too; give one of them");
  const auto factor = find(surface, name + "_prefactor");
  if (factor) prefactor = number(source, *factor, dimension::none, Domain::positive);
  if (factor && !zeta) reject(source, *factor, fault::misplaced, "has no effect without 'zeta_" + name + "'");
  if (own) return number(source, *own, damping_dimension, Domain::not_negative);
  if (!zeta) return 0;
  const double value = number(source, *zeta, dimension::none, Domain::not_negative);
  if (value == 0) return 0;
  if (!(material.adhesion > 0))
    reject(source, *zeta, fault::missing, "needs a work of adhesion (give 'damping_" + name + "' instead)");
  if (!density) reject(source, *zeta, fault::missing, "needs 'body.density'");
  return formula(value, *density, prefactor);
}

/// C_H that gives a restitution beside the other parameters; `law` has none yet.
double solve_hertz_damping(const Source& source, const Field& surface, const Field& restitution,
                           const contact::Surface& material, double radius, double damping_adhesion,
                           double mass, double speed) {
  for (const auto* key : {"damping_hertz", "zeta_hertz"})
    if (find(surface, key))
      reject(source, restitution, fault::contradiction,
             "'" + std::string(key) + "' is given, too; give one of them");
  const double e = number(source, restitution, dimension::none, Domain::positive);
  if (e > 1) reject(source, restitution, fault::out_of_range, "must not be above 1");
  const double at = optional_number(source, surface, "at", dimension::velocity, Domain::positive, speed);
  try {
    const auto damping = hertz_damping(material, radius, damping_adhesion, e, mass, at);
    if (!damping)
      reject(source, restitution, fault::out_of_range, "is out of reach: adhesion damping alone takes more");
    if (!std::isfinite(*damping))
      reject(source, restitution, fault::out_of_range, "has no damping that double precision can carry");
    return *damping;
  } catch (const InvalidParameter& error) {
    reject(source, restitution, error.fault, error.what());
  }
}

/// K, or (4/3) E* of the materials of body and surface.
double read_stiffness(const Source& source, const Field& surface, const Shape& shape,
                      const std::optional<Material>& plane) {
  if (find(surface, "stiffness") || !plane)
    return positive(source, surface, "stiffness", dimension::pressure);
  const auto a = elastic(*plane), b = elastic(shape.material.value_or(Material{}));
  if (!a || !b)
    reject(source, *find(surface, "material"), fault::no_stiffness,
           "gives a stiffness only with young and poisson of 'surface.material' and 'body.material'");
  return contact::hertz_stiffness(*a, infinity, *b, 1);
}

contact::BrachDunn read_law(const Source& source, const Field& surface, double radius, const Shape& shape,
                            const std::optional<Material>& plane, double speed) {
  const auto& density = shape.density;
  const contact::Surface material{.stiffness = read_stiffness(source, surface, shape, plane),
                                  .adhesion = optional_number(source, surface, "work_of_adhesion",
                                                              adhesion_dimension, Domain::not_negative, 0)};
  double hertz = read_damping(source, surface, "hertz", contact::hertz_prefactor, material, density,
                              [&](double zeta, double rho, double prefactor) {
                                return contact::hertz_damping(zeta, material, radius, rho, speed, prefactor);
                              });
  const double adhesion =
      read_damping(source, surface, "adhesion", contact::adhesion_prefactor, material, density,
                   [&](double zeta, double rho, double prefactor) {
                     return contact::adhesion_damping(zeta, material, radius, rho, speed, prefactor);
                   });
  const auto restitution = find(surface, "restitution");
  if (const auto at = find(surface, "at"); at && !restitution)
    reject(source, *at, fault::misplaced, "has no effect without 'restitution'");
  if (restitution)
    hertz = solve_hertz_damping(source, surface, *restitution, material, radius, adhesion, shape.body.mass,
                                speed);
  return contact::brach_dunn(material, radius, hertz, adhesion);
}

}  // namespace

void expect_surface_keys(const Source& source, const Field& surface) {
  expect_keys(source, surface, surface_keys);
}

std::optional<Material> read_surface(Source& source, const Field& surface, const Shape& shape, double speed,
                                     model::Microbody& body) {
  std::optional<Material> plane;
  ErrorList errors;
  const auto part = [&](const char* key, auto&& read) {
    const auto field = find(surface, key);
    return !field || errors.attempt([&] { read(*field); });
  };
  const bool known = part("material", [&](const Field& field) { plane = read_material(source, field); });
  part("law", [&](const Field& field) { choice(source, field, "law", laws); });
  for (const auto& tip : shape.body.tips)
    if (known)
      errors.attempt([&] { body.law.push_back(read_law(source, surface, tip.radius, shape, plane, speed)); });
  part("friction", [&](const Field& field) {
    body.friction = {number(source, field, dimension::none, Domain::not_negative)};
  });
  part("lever", [&](const Field& field) {
    const bool radius = choice(source, field, "lever", levers) == 0;
    body.lever = radius ? model::Lever::radius : model::Lever::indented;
  });
  errors.raise();
  return plane;
}

void check_surface(Source& source, const Field& surface) {
  constexpr Material material{.young = 1, .poisson = 0.3, .density = 1, .yield_strength = {}};
  Source silent = source;  // what there is to warn of is said when the surface is read for its body
  model::Microbody body;
  read_surface(silent, surface, {model::sphere(1, 1), 1, material}, 1, body);
}

}  // namespace mariotte::scene
