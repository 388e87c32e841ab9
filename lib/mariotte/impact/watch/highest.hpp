// The largest value that a quantity has within a step.
#pragma once
#include <algorithm>

#include "mariotte/core/bracket.hpp"

namespace mariotte::impact {

/// Largest value between two places of a function with at most one maximum there: where its slope falls
/// through zero, or at an end. It is flat there, so a loose place is enough for a tight value.
template <class Function>
double highest(Function&& f, double low, double high) {
  constexpr double loose = 1e-6;
  const auto slope = [&](double place) { return f(place + loose) - f(place - loose); };
  const double left = low + loose, right = high - loose;
  const double rise = slope(left), fall = slope(right);
  if (!(rise > 0 && fall < 0)) return std::max(f(low), f(high));
  return f(locate_sign_change(slope, left, rise, right, fall, loose));
}

}  // namespace mariotte::impact
