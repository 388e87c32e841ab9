// A force of cubic segments, which flows follow one after the other.
#pragma once
#include <algorithm>
#include <vector>

namespace mariotte {

/// f = a₀ + a₁ x + a₂ x² + a₃ x³ with x = δ − from, up to δ = to; the slope is as continuous as the force.
struct CubicSegment {
  double from, to;
  double a[4];

  double force(double indentation) const {
    const double x = indentation - from;
    return a[0] + x * (a[1] + x * (a[2] + x * a[3]));
  }
  /// df/dδ.
  double slope(double indentation) const {
    const double x = indentation - from;
    return a[1] + x * (2 * a[2] + x * 3 * a[3]);
  }
  /// ∫ f dδ since `from`.
  double energy(double indentation) const {
    const double x = indentation - from;
    return x * (a[0] + x * (a[1] / 2 + x * (a[2] / 3 + x * a[3] / 4)));
  }
};

/// Segments in order, each from the end of the one before; the last has no end.
using CubicCurve = std::vector<CubicSegment>;

/// The segment that holds an indentation; the first one below all.
inline const CubicSegment& segment_at(const CubicCurve& curve, double indentation) {
  const auto ends_before = [](const CubicSegment& segment, double d) { return segment.to <= d; };
  return *std::lower_bound(curve.begin(), curve.end() - 1, indentation, ends_before);
}

}  // namespace mariotte
