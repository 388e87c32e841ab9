#include "strike.hpp"

#include <numbers>

namespace mariotte::paper_figures {
namespace {

constexpr contact::Surface silicon = {.stiffness = 1.74e9, .adhesion = 0.38};
constexpr double density = 1350, zeta_hertz = 1.5, zeta_adhesion = 0.5;
constexpr double accuracy = 1e-10;

model::RigidBody shape_of(const Strike& strike) {
  if (strike.shape == "sphere") return model::sphere(strike.radius, density);
  if (strike.shape == "dumbbell") return model::dumbbell(strike.radius, strike.length_ratio, density);
  return model::rod(strike.radius, strike.length_ratio, density);
}

}  // namespace

model::Microbody microbody(const Strike& strike) {
  model::Microbody body;
  body.body = shape_of(strike);
  const auto law = contact::brach_dunn(
      silicon, strike.radius,
      contact::hertz_damping(zeta_hertz, silicon, strike.radius, density, strike.speed),
      contact::adhesion_damping(zeta_adhesion, silicon, strike.radius, density, strike.speed));
  body.law.assign(body.body.tips.size(), law);
  body.friction = {strike.friction};
  body.attitude = from_euler({0, strike.tilt * std::numbers::pi / 180, 0});
  body.velocity = {-strike.speed, 0, 0};
  return body;
}

impact::MicrobodyImpact simulate(const Strike& strike, bool trace) {
  return impact::simulate(microbody(strike), {.accuracy = accuracy}, {.trace = trace});
}

}  // namespace mariotte::paper_figures
