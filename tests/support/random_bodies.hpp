// Microbodies at random: every shape, in every direction.
#pragma once
#include <cmath>
#include <numbers>
#include <random>

#include "support/reference_bodies.hpp"

namespace mariotte::test {

/// A body that approaches with its first tip first; draws again until it does. Speeds from 0.3 to 30 m/s,
/// friction from none to 1.5, spins up to what makes the tip as fast as the mass centre.
inline model::Microbody random_body(std::mt19937& random) {
  std::uniform_real_distribution<double> one(-1, 1), positive(0, 1);
  for (;;) {
    const double radius = 1e-6 * (0.5 + 3 * positive(random)), ratio = 12 * positive(random);
    const int kind = static_cast<int>(3 * positive(random));
    model::Microbody body;
    body.body = kind == 0   ? model::sphere(radius, density)
                : kind == 1 ? model::dumbbell(radius, ratio, density)
                            : model::rod(radius, ratio, density);
    const double speed = 0.3 * std::pow(100, positive(random));
    const contact::Surface surface{.stiffness = 1.74e9,
                                   .adhesion = positive(random) < 0.2 ? 0 : 0.5 * positive(random)};
    const double damped = positive(random) < 0.2 ? 0 : 0.05 * positive(random) / std::sqrt(speed);
    body.law.assign(body.body.tips.size(), contact::brach_dunn(surface, radius, damped, damped));
    body.friction = {positive(random) < 0.2 ? 0 : 1.5 * positive(random)};
    body.attitude =
        from_euler({std::numbers::pi * one(random), 1.5 * one(random), std::numbers::pi * one(random)});
    body.velocity = {-speed * (0.1 + 0.9 * positive(random)), speed * one(random), speed * one(random)};
    const double spin = positive(random) < 0.3 ? 0 : speed / reach(body);
    body.spin = spin * Vector3{one(random), one(random), one(random)};
    if (!model::tip_below_plane(body) && model::tip_velocity(body, 0) < 0) return body;
  }
}

}  // namespace mariotte::test
