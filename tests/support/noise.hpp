// Noise that a seed makes again.
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "mariotte/study/sweep/random.hpp"

namespace mariotte::test {

/// Normally distributed with variance 1; a function of its arguments alone [Box & Muller 1958].
inline double normal(std::uint64_t seed, std::uint64_t counter) {
  const double radius = std::sqrt(-2 * std::log(1 - study::uniform(seed, 1, counter)));
  return radius * std::cos(2 * std::numbers::pi * study::uniform(seed, 2, counter));
}

}  // namespace mariotte::test
