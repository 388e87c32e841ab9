// Guards that are polynomials in the clock of a step.
#pragma once
#include "mariotte/flow/series_flow.hpp"

namespace mariotte::flow {

/// A guard: the sign times (offset + Σ row[k] xᵏ).
struct GuardSeries {
  std::span<const double> row;
  double sign = 1, offset = 0;

  double at(double place) const { return sign * (offset + horner(row, place)); }
};

/// End a step where a guard falls through zero. One that starts within `rounding` of its change starts at
/// zero. Where its series cannot tell, the step ends earlier, without a guard.
void look(Index guard, const GuardSeries& series, double rounding, SeriesEnd& end);

/// How far a polynomial can go from where it begins, up to a place.
double most_change(std::span<const double> row, double place);

}  // namespace mariotte::flow
