// Random numbers without a state: a counter goes in, a number comes out.
#pragma once
#include <cstdint>

namespace mariotte::study {

/// A bijection of 64 bits that leaves no trace of the order of its arguments: the finaliser of SplitMix64
/// [Steele, Lea & Flood 2014].
constexpr std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// Evenly distributed in [0, 1), to 53 bits; a function of its arguments alone.
constexpr double uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
  return static_cast<double>(mix(mix(mix(seed) ^ stream) ^ counter) >> 11) * 0x1p-53;
}

}  // namespace mariotte::study
