// Random numbers of one scene: the same ones whoever asks, and whenever.
#pragma once
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "mariotte/study/sweep/random.hpp"

namespace mariotte::stress_study {

/// A sequence that depends on a seed and the number of a scene alone.
class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t scene) : seed_(seed), scene_(scene) {}

  double uniform(double low, double high) {
    return low + (high - low) * study::uniform(seed_, scene_, count_++);
  }
  /// low ≤ number ≤ high.
  int whole(int low, int high) {
    return low + static_cast<int>(uniform(0, 1) * static_cast<double>(high - low + 1));
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  /// Evenly distributed logarithm.
  double between(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }
  /// Around 1, over so many powers of ten.
  double decades(double count) { return std::pow(10, uniform(-count / 2, count / 2)); }
  double pick(std::initializer_list<double> values) {
    return values.begin()[whole(0, static_cast<int>(values.size()) - 1)];
  }

 private:
  std::uint64_t seed_, scene_, count_ = 0;
};

}  // namespace mariotte::stress_study
