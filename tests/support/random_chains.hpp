// Random chains for property tests: always the same ones.
#pragma once
#include <random>

#include "mariotte/model/chain.hpp"

namespace mariotte::test {

/// n ≤ 12 balls, masses over 2 decades, stiffnesses over 4, mixed laws, gaps on half of the contacts, random
/// velocities.
inline model::Chain random_chain(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto decades = [&](double count) { return std::pow(10.0, uniform(-count / 2, count / 2)); };
  const int balls = std::uniform_int_distribution(2, 12)(random);
  model::Chain chain;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(decades(2));
    chain.velocity.push_back(uniform(-1, 1));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(uniform(0, 1) < 0.5 ? 0 : uniform(0, 2));
    const double stiffness = decades(4);
    switch (std::uniform_int_distribution(0, 3)(random)) {
      case 0:
        chain.law.push_back(contact::Linear{stiffness});
        break;
      case 1:
        chain.law.push_back(contact::Hertz{stiffness});
        break;
      case 2:
        chain.law.push_back(contact::Viscoelastic{stiffness, decades(2) * std::sqrt(stiffness), 1.5});
        break;
      default:
        chain.law.push_back(contact::Viscoelastic{stiffness, decades(2) * std::sqrt(stiffness), 1});
    }
  }
  return chain;
}

}  // namespace mariotte::test
