// Contact networks for tests and examples of them.
#pragma once
#include <cmath>
#include <random>

#include "mariotte/model/network/network.hpp"

namespace mariotte::test {

inline contact::Law hertz_of_pair(Index, Index) {
  return contact::Hertz{1};
}

/// Bernoulli's problem: ball 1 strikes two that touch each other, all three equal, at unit speed along x.
inline model::Network one_on_two() {
  const double half = 0.5, height = std::sqrt(3.0) / 2;
  const std::vector<model::Ball> balls = {
      {{-height, 0}, {1, 0}, 1, half}, {{0, half}, {0, 0}, 1, half}, {{0, -half}, {0, 0}, 1, half}};
  return model::ball_network(balls, 0.1, hertz_of_pair);
}

/// A triangle of rows of 1, 2, … balls of radius 1/2 that touch, struck at its tip along x by one more.
inline model::Network rack(int rows, double gap) {
  std::vector<model::Ball> balls = {{{-1 - gap, 0.05}, {1, 0}, 1, 0.5}};
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i <= row; ++i)
      balls.push_back({{row * std::sqrt(3.0) / 2, i - 0.5 * row}, {0, 0}, 1, 0.5});
  return model::ball_network(balls, 0.1, hertz_of_pair);
}

/// A square lattice of disks, `side` by `side`, with its diagonal neighbours apart, all moving at random.
template <class LawOfPair>
model::Network lattice(int side, std::mt19937_64& random, LawOfPair&& law) {
  std::uniform_real_distribution<double> speed(-1, 1);
  std::vector<model::Ball> balls;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      balls.push_back({{1.0 * i, 1.0 * j}, {speed(random), speed(random)}, 1, 0.5});
  return model::ball_network(balls, 0.1, law);
}

/// Such a lattice of Hertz contacts, damped or not.
inline model::Network packing(int side, double damping, std::mt19937_64& random) {
  return lattice(side, random, [&](Index, Index) -> contact::Law {
    if (damping == 0) return contact::Hertz{1};
    return contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = 1.5};
  });
}

/// The same network with other laws.
inline model::Network with_law(model::Network network, const contact::Law& law) {
  for (auto& each : network.law) each = law;
  return network;
}

}  // namespace mariotte::test
