// Root of a scalar function between two points of opposite sign.
#pragma once
#include <cmath>

namespace mariotte {

/// Time in [low, high] at which f changes sign, to `tolerance` in time; regula falsi with the Illinois rule,
/// which takes turns with halving where it is not quick. f(low) and f(high) are given and must not have the
/// same sign.
template <class Function>
double locate_sign_change(Function&& f, double low, double f_low, double high, double f_high,
                          double tolerance) {
  constexpr int quick = 8, most = 120;  // steps
  bool high_moved = false, low_moved = false;
  for (int i = 0; i < most && high - low > tolerance; ++i) {
    const bool halves = i >= quick && i % 2 == 0;
    const double middle = halves ? low + 0.5 * (high - low) : high - f_high * (high - low) / (f_high - f_low);
    const double value = f(middle);
    if (value == 0) return middle;
    const bool moves_high = (value > 0) == (f_high > 0);
    if (moves_high) {
      if (high_moved) f_low /= 2;  // the other end has stayed: halve its weight
      high = middle;
      f_high = value;
    } else {
      if (low_moved) f_high /= 2;
      low = middle;
      f_low = value;
    }
    high_moved = moves_high;
    low_moved = !moves_high;
  }
  return std::abs(f_low) < std::abs(f_high) ? low : high;
}

/// Place between `from`, where f > 0, and `to`, where f ≤ 0, at which f is zero: Newton's method from `to`,
/// kept between them, until it moves by `tolerance` at most. f gives a value and a slope.
template <class Function>
double locate_fall(Function&& f, double from, double to, double tolerance) {
  double x = to;
  for (int i = 0; i < 100; ++i) {
    const auto [value, slope] = f(x);
    if (value == 0) return x;
    (value > 0 ? from : to) = x;
    double next = x - value / slope;
    if (!((next - from) * (next - to) <= 0)) next = 0.5 * (from + to);
    if (std::abs(next - x) <= tolerance) return next;
    x = next;
  }
  return x;
}

}  // namespace mariotte
