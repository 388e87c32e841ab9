#include "mariotte/scene/body_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/scene/angle.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/shape.hpp"
#include "mariotte/scene/surface_reader.hpp"
#include "mariotte/scene/touching.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 4> incidence_keys{"normal_speed", "tangential_velocity", "angles",
                                                         "spin"};
constexpr std::array<std::string_view, 2> after{"stop", "continue"};
constexpr Index most_impacts = 1'000'000;

Field table(const Source& source, const Field& root, const char* key) {
  const auto field = find(root, key);
  if (!field)
    reject(source, root.place(), fault::no_model, "the scene has a [body] but no [" + std::string(key) + "]");
  return *field;
}

double read_speed(const Source& source, const Field& incidence) {
  const auto field = find(incidence, "normal_speed");
  if (!field) reject(source, incidence, fault::missing, "'normal_speed' is missing");
  const double speed = number(source, *field, dimension::velocity, Domain::finite);
  if (!(speed > 0))
    reject(source, *field, fault::wrong_start, "must be positive: the body has to approach the plane");
  return speed;
}

std::string hint_of_largest(const Vector3& angles) {
  return hint_at_radians(std::max({std::abs(angles.e1), std::abs(angles.e2), std::abs(angles.e3)}));
}

void read_tangential(const Source& source, const Field& field, model::Microbody& body) {
  if (!field.node->array() || field.node->array()->size() != 2)
    reject(source, field, fault::wrong_length, "expected an array of two values, along e2 and e3");
  body.velocity.e2 = number(source, element(field, 0), dimension::velocity, Domain::finite);
  body.velocity.e3 = number(source, element(field, 1), dimension::velocity, Domain::finite);
}

void read_angles(Source& source, const Field& field, model::Microbody& body) {
  const Vector3 angles = read_vector(source, field, dimension::none);
  if (const auto hint = hint_of_largest(angles); !hint.empty())
    warn(source, field, "more than a full turn" + hint);
  body.attitude = from_euler({angles.e1, angles.e2, angles.e3});
}

void read_incidence(Source& source, const Field& incidence, model::Microbody& body) {
  ErrorList errors;
  const auto part = [&](const char* key, auto&& read) {
    if (const auto field = find(incidence, key)) errors.attempt([&] { read(*field); });
  };
  errors.attempt([&] { expect_keys(source, incidence, incidence_keys); });
  errors.attempt([&] { body.velocity.e1 = -read_speed(source, incidence); });
  part("tangential_velocity", [&](const Field& field) { read_tangential(source, field, body); });
  part("angles", [&](const Field& field) { read_angles(source, field, body); });
  part("spin", [&](const Field& field) { body.spin = read_vector(source, field, dimension::rate); });
  errors.raise();
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
  const auto hint = angles ? hint_of_largest(read_vector(source, *angles, dimension::none)) : std::string();
  if (const auto tip = model::tip_below_plane(body))
    reject(
        source, blame("angles"), fault::wrong_start,
        "tip " + std::to_string(*tip + 1) + " would start below the plane: these angles put it first" + hint);
  if (!(model::tip_velocity(body, 0) < 0))
    reject(source, blame("spin"), fault::wrong_start,
           "the spin lifts tip 1 off the plane" +
               std::string(body.body.tips.size() > 1 ? "; the other tip would be first" : ""));
}

/// Every tip is a ball of the body's mass for what touches it.
std::vector<impact::Touching> touching_of_tips(const Shape& shape, const std::optional<Material>& plane) {
  std::vector<impact::Touching> list;
  for (const auto& tip : shape.body.tips)
    list.push_back(
        touching(Ball{shape.body.mass, tip.radius, shape.material, {}}, Ball{infinity, infinity, plane, {}}));
  return list;
}

}  // namespace

ResolvedBody read_microbody(Source& source, const Field& root, const std::optional<Field>& run) {
  const auto surface = table(source, root, "surface"), incidence = table(source, root, "incidence");
  ErrorList errors;
  Shape shape;
  model::Microbody body;
  const bool shaped = errors.attempt([&] { shape = read_shape(source, *find(root, "body")); });
  errors.attempt([&] { expect_surface_keys(source, surface); });
  const bool moves = errors.attempt([&] { read_incidence(source, incidence, body); });
  if (!shaped || !moves) errors.attempt([&] { check_surface(source, surface); });
  errors.attempt([&] { read_run_of_body(source, run, body); });
  errors.raise();
  body.body = shape.body;
  const auto plane = read_surface(source, surface, shape, -body.velocity.e1, body);
  expect_first_tip_first(source, incidence, body);
  return {std::move(body), touching_of_tips(shape, plane)};
}

}  // namespace mariotte::scene
