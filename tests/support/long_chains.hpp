// Long chains for tests.
#pragma once
#include <random>

#include "support/reference.hpp"

namespace mariotte::test {

/// Masses over two decades, gaps on half of the contacts, struck from the left.
inline model::Chain random_long_chain(std::size_t balls) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  auto chain = equal_chain(balls);
  for (double& m : chain.mass) m = std::pow(10.0, uniform(-1, 1));
  for (double& gap : chain.gap) gap = uniform(0, 1) < 0.5 ? 0 : uniform(0, 2);
  return chain;
}

}  // namespace mariotte::test
