#include "mariotte/scene/body_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/restitution.hpp"
#include "mariotte/scene/shape.hpp"

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
constexpr std::array<std::string_view, 4> incidence_keys{"normal_speed", "tangential_velocity", "angles",
                                                         "spin"};
constexpr std::array<std::string_view, 1> laws{"brach-dunn"};
constexpr std::array<std::string_view, 2> levers{"radius", "indented"};
constexpr std::array<std::string_view, 2> after{"stop", "continue"};
constexpr Dimension adhesion_dimension{.kg = 1, .s = -2};
constexpr Dimension damping_dimension{.m = -1, .s = 1};
constexpr Dimension spin_dimension{.s = -1};
constexpr Index most_impacts = 1'000'000;

Field table(const Source& source, const Field& root, const char* key) {
  const auto field = find(root, key);
  if (!field)
    reject(source, root.place(), fault::no_model, "the scene has a [body] but no [" + std::string(key) + "]");
  return *field;
}

double positive(const Source& source, const Field& table, const char* key, const Dimension& dimension) {
  const auto field = find(table, key);
  if (!field) reject(source, table, fault::missing, "'" + std::string(key) + "' is missing");
  return number(source, *field, dimension, Domain::positive);
}

double optional_number(const Source& source, const Field& table, const char* key, const Dimension& dimension,
                       Domain domain, double otherwise) {
  const auto field = find(table, key);
  return field ? number(source, *field, dimension, domain) : otherwise;
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
  const auto damping = hertz_damping(material, radius, damping_adhesion, e, mass, at);
  if (!damping)
    reject(source, restitution, fault::out_of_range, "is out of reach: adhesion damping alone takes more");
  return *damping;
}

/// K, or (4/3) E* of the materials of body and surface.
double read_stiffness(Source& source, const Field& surface, const Shape& shape) {
  const auto own = find(surface, "material");
  if (find(surface, "stiffness") || !own) return positive(source, surface, "stiffness", dimension::pressure);
  const auto plane = elastic(read_material(source, *own));
  const auto body = elastic(shape.material.value_or(Material{}));
  if (!plane || !body)
    reject(source, *own, fault::no_stiffness,
           "gives a stiffness only with young and poisson of 'surface.material' and 'body.material'");
  return contact::hertz_stiffness(*plane, infinity, *body, 1);
}

contact::BrachDunn read_law(Source& source, const Field& surface, double radius, const Shape& shape,
                            double speed) {
  const auto& density = shape.density;
  const contact::Surface material{.stiffness = read_stiffness(source, surface, shape),
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
  if (const auto restitution = find(surface, "restitution"))
    hertz = solve_hertz_damping(source, surface, *restitution, material, radius, adhesion, shape.body.mass,
                                speed);
  return contact::brach_dunn(material, radius, hertz, adhesion);
}

void read_surface(Source& source, const Field& surface, const Shape& shape, double speed,
                  model::Microbody& body) {
  if (const auto law = find(surface, "law")) choice(source, *law, "law", laws);
  for (const auto& tip : shape.body.tips)
    body.law.push_back(read_law(source, surface, tip.radius, shape, speed));
  body.friction = {optional_number(source, surface, "friction", dimension::none, Domain::not_negative, 0)};
  if (const auto lever = find(surface, "lever"))
    body.lever = choice(source, *lever, "lever", levers) == 0 ? model::Lever::radius : model::Lever::indented;
}

double read_speed(const Source& source, const Field& incidence) {
  const auto field = find(incidence, "normal_speed");
  if (!field) reject(source, incidence, fault::missing, "'normal_speed' is missing");
  const double speed = number(source, *field, dimension::velocity, Domain::finite);
  if (!(speed > 0))
    reject(source, *field, fault::wrong_start, "must be positive: the body has to approach the plane");
  return speed;
}

/// Angles of more than a turn were meant in degrees.
std::string hint_at_radians(const Vector3& angles) {
  const double most = std::max({std::abs(angles.e1), std::abs(angles.e2), std::abs(angles.e3)});
  return most > 2 * std::numbers::pi ? " (a bare number is in radians; \"42 deg\" is in degrees)" : "";
}

void read_incidence(Source& source, const Field& incidence, model::Microbody& body) {
  body.velocity = {-read_speed(source, incidence), 0, 0};
  if (const auto field = find(incidence, "tangential_velocity")) {
    if (!field->node->array() || field->node->array()->size() != 2)
      reject(source, *field, fault::wrong_length, "expected an array of two values, along e2 and e3");
    body.velocity.e2 = number(source, element(*field, 0), dimension::velocity, Domain::finite);
    body.velocity.e3 = number(source, element(*field, 1), dimension::velocity, Domain::finite);
  }
  if (const auto field = find(incidence, "angles")) {
    const Vector3 angles = read_vector(source, *field, dimension::none);
    if (const auto hint = hint_at_radians(angles); !hint.empty())
      warn(source, *field, "more than a full turn" + hint);
    body.attitude = from_euler({angles.e1, angles.e2, angles.e3});
  }
  if (const auto field = find(incidence, "spin")) body.spin = read_vector(source, *field, spin_dimension);
}

void read_run_of_body(const Source& source, const std::optional<Field>& run, model::Microbody& body) {
  if (!run) return;
  body.gravity = optional_number(source, *run, "gravity", dimension::acceleration, Domain::finite, 0);
  if (const auto field = find(*run, "impacts")) body.impacts = whole(source, *field, 1, most_impacts);
  const auto captured = find(*run, "after_capture");
  if (!captured || choice(source, *captured, "word", after) == 0) return;
  if (!find(*run, "max_time") && !find(*run, "until"))
    reject(source, *captured, fault::missing,
           "a captured body moves for ever; 'continue' needs 'run.max_time' or 'run.until'");
  body.after_capture = model::AfterCapture::go_on;
}

/// What is wrong with the start, at the key that makes it so.
void expect_first_tip_first(const Source& source, const Field& incidence, const model::Microbody& body) {
  const auto blame = [&](const char* key) { return find(incidence, key).value_or(incidence); };
  const auto angles = find(incidence, "angles");
  const auto hint = angles ? hint_at_radians(read_vector(source, *angles, dimension::none)) : std::string();
  if (const auto tip = model::tip_below_plane(body))
    reject(
        source, blame("angles"), fault::wrong_start,
        "tip " + std::to_string(*tip + 1) + " would start below the plane: these angles put it first" + hint);
  if (!(model::tip_velocity(body, 0) < 0))
    reject(source, blame("spin"), fault::wrong_start,
           "the spin lifts tip 1 off the plane" +
               std::string(body.body.tips.size() > 1 ? "; the other tip would be first" : ""));
}

}  // namespace

model::Microbody read_microbody(Source& source, const Field& root, const std::optional<Field>& run) {
  const auto surface = table(source, root, "surface"), incidence = table(source, root, "incidence");
  ErrorList errors;
  Shape shape;
  model::Microbody body;
  errors.attempt([&] { shape = read_shape(source, *find(root, "body")); });
  errors.attempt([&] { expect_keys(source, surface, surface_keys); });
  errors.attempt([&] {
    expect_keys(source, incidence, incidence_keys);
    read_incidence(source, incidence, body);
  });
  errors.attempt([&] { read_run_of_body(source, run, body); });
  errors.raise();
  body.body = shape.body;
  read_surface(source, surface, shape, -body.velocity.e1, body);
  expect_first_tip_first(source, incidence, body);
  return body;
}

}  // namespace mariotte::scene
