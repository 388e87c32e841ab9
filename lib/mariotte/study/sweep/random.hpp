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

/// The place of `position` in a random order of 0 … count − 1: a Feistel network of four rounds over the
/// least power of four that is large enough, walked until it comes back below `count`.
constexpr std::uint64_t shuffled(std::uint64_t seed, std::uint64_t stream, std::uint64_t count,
                                 std::uint64_t position) {
  int half = 1;
  while (half < 32 && (std::uint64_t{1} << 2 * half) < count) ++half;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1, key = mix(mix(seed) ^ stream);
  do {
    for (std::uint64_t round = 0; round < 4; ++round) {
      const std::uint64_t left = position >> half, right = position & mask;
      position = right << half | (left ^ (mix(key ^ (round << 60) ^ right) & mask));
    }
  } while (position >= count);
  return position;
}

}  // namespace mariotte::study
