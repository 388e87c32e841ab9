#include "mariotte/scene/touching.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/contact/limits.hpp"
#include "mariotte/scene/restitution.hpp"

namespace mariotte::scene {
namespace {

/// 0 of a plane, of a rigid body, and where Young's modulus or the density is not known.
double wave_travel(const Ball& ball) {
  if (!ball.material || !std::isfinite(*ball.radius)) return 0;
  const auto& [young, poisson, density, yield_strength] = *ball.material;
  return young && density ? contact::wave_travel(*ball.radius, *density, *young) : 0;
}

/// 0 where it is not known of both.
double yield_strength(const Ball& left, const Ball& right) {
  const auto of = [](const Ball& ball) {
    return ball.material ? ball.material->yield_strength.value_or(0) : 0;
  };
  const double a = of(left), b = of(right);
  return a > 0 && b > 0 ? std::min(a, b) : std::max(a, b);
}

}  // namespace

impact::Touching touching(const Ball& left, const Ball& right) {
  if (!left.radius || !right.radius) return {};
  return {.radius = 1 / (1 / *left.radius + 1 / *right.radius),
          .smaller_radius = std::min(*left.radius, *right.radius),
          .yield_strength = yield_strength(left, right),
          .wave_travel = std::max(wave_travel(left), wave_travel(right)),
          .mass = reduced_mass(*left.mass, *right.mass)};
}

std::vector<impact::Touching> touching(std::span<const Ball> balls) {
  std::vector<impact::Touching> list;
  if (std::none_of(balls.begin(), balls.end(), [](const Ball& ball) { return ball.radius.has_value(); }))
    return list;
  list.reserve(balls.size() - 1);
  for (std::size_t j = 1; j < balls.size(); ++j) list.push_back(touching(balls[j - 1], balls[j]));
  return list;
}

}  // namespace mariotte::scene
