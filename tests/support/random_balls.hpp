// Balls of the plane with random masses, velocities and spins; the same in every run of a program.
#pragma once
#include <random>

#include "mariotte/model/bodies/bodies.hpp"

namespace mariotte::test {

constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;

inline std::mt19937 random_numbers(7);

inline double in(double low, double high) {
  return std::uniform_real_distribution(low, high)(random_numbers);
}

inline model::Body ball(const Vector3& position) {
  return {.name = "",
          .mass = mass * in(0.5, 2),
          .inertia = {moment, moment, moment * in(0.5, 2)},
          .spheres = {{{}, radius}},
          .position = position,
          .velocity = {in(-1, 1), in(-1, 1), 0},
          .spin = {0, 0, in(-50, 50)}};
}

}  // namespace mariotte::test
