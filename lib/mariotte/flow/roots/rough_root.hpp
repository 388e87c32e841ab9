// A root for step sizes, which need no digits.
#pragma once
#include <bit>
#include <cstdint>

namespace mariotte::flow {

/// x^{1/n} to some per cent, x > 0 and normal: the exponent bits divided by n.
inline double rough_root(double x, double n) {
  constexpr std::int64_t one = 0x3fef000000000000;
  const auto above = static_cast<double>(std::bit_cast<std::int64_t>(x) - one);
  return std::bit_cast<double>(static_cast<std::int64_t>(above / n) + one);
}

}  // namespace mariotte::flow
