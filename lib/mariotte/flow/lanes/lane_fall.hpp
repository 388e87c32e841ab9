// Where a polynomial of a lane falls to zero; included as the series are.
#pragma once
#include <optional>
#include <span>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// The root of a polynomial that falls from above zero to `last`, from that of the parabola through its ends;
/// −1 where it does not come soon.
inline double newton(std::span<const double> c, double end, double last) {
  const double bend = (last - c[0] - c[1] * end) / (end * end), square = c[1] * c[1] - 4 * bend * c[0];
  double x = square > 0 ? 2 * c[0] / (__builtin_sqrt(square) - c[1]) : end;
  for (int i = 0; i < 6; ++i) {
    double value = 0, slope = 0;
    for (std::size_t k = c.size(); k-- > 0;) {
      slope = slope * x + value;
      value = value * x + c[k];
    }
    const double change = value / slope;
    x -= change;
    if (change * change <= epsilon * x * x) return x;  // the next one would be its square
  }
  return -1;
}

/// The first one until `end`; proven. What falls all the way comes to it quickly.
inline std::optional<double> first_fall(std::span<const double> c, double end) {
  if (c[0] > 0 && falls(c, end)) {
    const double last = horner(c, end);
    if (last > 0) return std::nullopt;
    if (const double root = newton(c, end, last); root >= 0 && root <= end) return root;
  }
  return flow::first_fall(c, end);
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
