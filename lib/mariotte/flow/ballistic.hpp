// When free flight crosses a guard.
#pragma once
#include "mariotte/flow/problem.hpp"

namespace mariotte::flow {

/// Smallest t > 0 at which value + rate t + bend t²/2 crosses zero the given way; infinite if it never does.
/// A value of zero at t = 0 is not a crossing. No intermediate overflows unless the answer does.
double first_crossing(Crossing crossing, double value, double rate, double bend);

}  // namespace mariotte::flow
