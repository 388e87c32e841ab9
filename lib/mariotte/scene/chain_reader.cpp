#include "mariotte/scene/chain_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/scene/balls.hpp"
#include "mariotte/scene/contacts.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/touching.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 21> keys{
    "diameter", "taper",    "repeat",   "restitution",   "at",        "balls",   "mass",
    "radius",   "material", "velocity", "law",           "stiffness", "damping", "exponent",
    "gap",      "gravity",  "wall",     "wall_material", "ball",      "contact", "precompressed"};

double read_gravity(const Source& source, const Field& chain, const std::optional<Field>& of_run) {
  const auto own = find(chain, "gravity");
  if (own && of_run) reject(source, *of_run, fault::contradiction, "gravity is given by 'chain.gravity' too");
  const auto field = own ? own : of_run;
  return field ? number(source, *field, dimension::acceleration, Domain::finite) : 0;
}

void expect_motion(const Source& source, const Field& chain, const model::Chain& model) {
  const auto wall = [](double mass) { return std::isinf(mass); };
  for (std::size_t i = 1; i < model.mass.size(); ++i)
    if (wall(model.mass[i - 1]) && wall(model.mass[i]))
      reject(source, find(chain, "mass").value_or(chain), fault::impossible,
             "balls " + std::to_string(i) + " and " + std::to_string(i + 1) +
                 " are both walls (of infinite mass); a contact needs a ball");
}

void warn_of_rest(Source& source, const Field& chain, const model::Chain& model) {
  const auto zero = [](double value) { return value == 0; };
  const bool pressed = std::any_of(model.gap.begin(), model.gap.end(), [](double gap) { return gap < 0; });
  if (model.gravity == 0 && !pressed && std::all_of(model.velocity.begin(), model.velocity.end(), zero))
    warn(source, chain, "nothing moves: no velocity, no gravity, no compressed contact");
}

std::vector<double> radii(const std::vector<Ball>& balls) {
  std::vector<double> result;
  for (const auto& ball : balls) {
    if (!ball.radius) return {};
    result.push_back(*ball.radius);
  }
  return result;
}

}  // namespace

ResolvedChain read_chain(Source& source, const Field& chain, const std::optional<Field>& gravity) {
  expect_keys(source, chain, keys);
  const auto layout = read_layout(source, chain);
  model::Chain model;
  std::vector<Ball> balls;
  ErrorList errors;
  errors.attempt([&] {
    balls = read_balls(source, chain, layout);
    for (const auto& ball : balls) {
      model.mass.push_back(*ball.mass);
      model.velocity.push_back(ball.velocity.value_or(0));
    }
    model.law = read_laws(source, chain, layout, balls);
  });
  errors.attempt([&] {
    if (const auto field = find(chain, "precompressed")) model.precompressed = boolean(source, *field);
    model.gap = read_gaps(source, chain, layout, model.precompressed);
  });
  errors.attempt([&] { model.gravity = read_gravity(source, chain, gravity); });
  errors.raise();
  expect_motion(source, chain, model);
  warn_of_rest(source, chain, model);
  return {std::move(model), radii(balls), touching(balls)};
}

}  // namespace mariotte::scene
