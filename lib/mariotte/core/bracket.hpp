// Root of a scalar function between two points of opposite sign.
#pragma once
#include <cmath>

namespace mariotte {

/// Time in [low, high] at which f changes sign, to `tolerance` in time; regula falsi with the Illinois rule.
/// f(low) and f(high) are given and must not have the same sign.
template <class Function>
double locate_sign_change(Function&& f, double low, double f_low, double high, double f_high,
                          double tolerance) {
  for (int i = 0; i < 60 && high - low > tolerance; ++i) {
    const double middle = high - f_high * (high - low) / (f_high - f_low);
    const double value = f(middle);
    if (value == 0) return middle;
    if ((value > 0) == (f_high > 0)) {
      f_low /= 2;  // the other end has stayed: halve its weight
      high = middle;
      f_high = value;
    } else {
      f_high /= 2;
      low = middle;
      f_low = value;
    }
  }
  return std::abs(f_low) < std::abs(f_high) ? low : high;
}

}  // namespace mariotte
