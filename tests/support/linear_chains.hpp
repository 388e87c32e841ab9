// Chains of linear contacts, for the tests of their natural modes.
#pragma once
#include <cmath>
#include <random>

#include "mariotte/model/chain/chain.hpp"

namespace mariotte::test {

inline contact::Law damper(double stiffness, double damping) {
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = 1};
}

/// Chains of linear springs only: 3 to 8 balls, masses over 2 decades, stiffnesses over 6, half of the
/// contacts apart.
inline model::Chain random_springs(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const int balls = std::uniform_int_distribution(3, 8)(random);
  model::Chain chain;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(std::pow(10, uniform(-1, 1)));
    chain.velocity.push_back(uniform(-1, 1));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(uniform(0, 1) < 0.5 ? 0 : uniform(0, 1));
    chain.law.push_back(contact::Linear{std::pow(10, uniform(-3, 3))});
  }
  return chain;
}

}  // namespace mariotte::test
