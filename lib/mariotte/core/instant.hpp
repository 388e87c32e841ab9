// Points in time far from the start: an hour after it, a microsecond is still told to the last digit.
#pragma once
#include <cmath>
#include <compare>

namespace mariotte {

/// A time as the unevaluated sum of two doubles, the second within half a last place of the first.
struct Instant {
  double value = 0;
  double rest = 0;

  auto operator<=>(const Instant&) const = default;
};

/// Error below 2⁻¹⁰⁰ of the result.
inline Instant operator+(Instant t, double duration) {
  const double sum = t.value + duration;
  if (!std::isfinite(sum)) return {sum, 0};
  const double part = sum - t.value;
  const double lost = (t.value - (sum - part)) + (duration - part) + t.rest;
  const double value = sum + lost;
  return {value, lost - (value - sum)};
}

/// The time from b to a.
inline double operator-(Instant a, Instant b) {
  return (a.value - b.value) + (a.rest - b.rest);
}

}  // namespace mariotte
