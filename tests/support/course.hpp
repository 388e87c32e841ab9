// A guard over one step of the oracle, with its turning points.
#pragma once
#include "support/series_motion.hpp"

namespace mariotte::test {

/// Where f, of opposite signs at both ends, is zero to the last bits; regula falsi with the Illinois rule.
template <class F>
double zero(F&& f, double from, double to) {
  double low = f(from), high = f(to), last = from;
  for (int i = 0; i < 100; ++i) {
    const double middle = to - high * (to - from) / (high - low), value = f(middle);
    if (value == 0 || std::abs(middle - last) <= 2 * epsilon * middle) return middle;
    last = middle;
    if ((value > 0) == (high > 0)) {
      low /= 2;  // the far end has stayed
    } else {
      from = to;
      low = high;
    }
    to = middle;
    high = value;
  }
  return last;
}

struct Course {
  Series series;
  std::vector<double> turns;  ///< in order of time

  double value(double time) const { return SeriesMotion::value(series, time); }
  double slope(double time) const { return SeriesMotion::slope(series, time); }

  double curvature(double time) const {
    double sum = 0;
    for (int k = series_order; k >= 2; --k) sum = sum * time + k * (k - 1) * series[k];
    return sum;
  }

  /// Turning points in (0, end). The slope is looked at in nine places, and where it comes nearest to zero
  /// between two of them: after an uncut force has turned round, two turns may stand close together.
  void find_turns(double end) {
    constexpr int parts = 8;
    std::array<double, parts + 1> at{}, bend{};
    for (int k = series_order; k >= 1; --k)
      for (int i = 0; i <= parts; ++i) at[i] = at[i] * (end * i / parts) + k * series[k];
    for (int k = series_order; k >= 2; --k)
      for (int i = 0; i <= parts; ++i) bend[i] = bend[i] * (end * i / parts) + k * (k - 1) * series[k];
    const auto slope_at = [&](double t) { return slope(t); };
    const auto add = [&](double from, double to) { turns.push_back(zero(slope_at, from, to)); };
    turns.clear();
    for (int i = 0; i < parts; ++i) {
      const double from = end * i / parts, to = end * (i + 1) / parts;
      if (at[i] * at[i + 1] < 0) {
        add(from, to);
      } else if (at[i] * bend[i] < 0 && at[i + 1] * bend[i + 1] > 0) {
        const double nearest = zero([&](double t) { return curvature(t); }, from, to);
        if (at[i] * slope(nearest) >= 0) continue;
        add(from, nearest);
        add(nearest, to);
      }
    }
  }
};

}  // namespace mariotte::test
