// Balls with friction that strike a plane, or each other.
#pragma once
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/model/bodies/bodies.hpp"

namespace mariotte::test {

using model::TangentialLaw;

inline constexpr double mass = 0.033, radius = 0.01, stiffness = 9e9;

inline model::Body ball(const Vector3& position, const Vector3& velocity, const Vector3& spin = {}) {
  const double moment = 0.4 * mass * radius * radius;
  return {.name = "",
          .mass = mass,
          .inertia = {moment, moment, moment},
          .spheres = {{{}, radius}},
          .position = position,
          .velocity = velocity,
          .spin = spin};
}

/// One ball that strikes the plane y = 0.
inline model::Bodies strike(double angle, const model::Tangential& tangential,
                            contact::Law law = contact::Hertz(stiffness)) {
  model::Bodies bodies{.dimension = 2};
  bodies.body = {ball({0, radius, 0}, {std::sin(angle), -std::cos(angle), 0})};
  bodies.plane = {{.name = "", .point = {}, .normal = {0, 1, 0}, .velocity = {}}};
  bodies.contact = {
      {.a = {0, -1}, .b = {0, 0}, .law = law, .tangential = tangential, .share = 0, .touching = true}};
  bodies.named = 1;
  return bodies;
}

/// Two balls in the plane that meet obliquely, with spin.
inline model::Bodies meeting(const model::Tangential& tangential, double share = 0.5) {
  model::Bodies bodies{.dimension = 2};
  bodies.body = {ball({0, 0, 0}, {1, 0.3, 0}, {0, 0, 40}),
                 ball({0.0195, 0.006, 0}, {-0.2, 0.1, 0}, {0, 0, -25})};
  bodies.contact = {
      {.a = {0, 0}, .b = {1, 0}, .law = contact::Hertz(1e6), .tangential = tangential, .share = share}};
  bodies.named = 1;
  return bodies;
}

inline constexpr model::Tangential mindlin{TangentialLaw::mindlin, 0.2, 1.2e6};
inline constexpr model::Tangential spring{TangentialLaw::spring, 0.2, 3e5};
inline constexpr model::Tangential rigid{TangentialLaw::rigid, 0.2, 0};

inline void check_near(double value, double expected, double tolerance) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, value << " instead of " << expected);
}

}  // namespace mariotte::test
