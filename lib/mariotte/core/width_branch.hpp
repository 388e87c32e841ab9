// A branch of a contact law in the root u = √a of a contact radius, in which it is a polynomial:
//
//     δ = δ₀ + u⁴/R − s u,    f = Σ pᵢ uⁱ + η u² δ̇
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/core/types.hpp"

namespace mariotte {

/// δ(u), which falls to its last value at u³ = sR/4.
struct WidthCurve {
  double radius;      ///< R
  double s;           ///< s
  double origin = 0;  ///< δ₀

  double last() const { return std::cbrt(s * radius / 4); }
  double indentation(double u) const { return origin + u * (u * u * u / radius - s); }
  /// dδ/du.
  double slope(double u) const { return 4 * u * u * u / radius - s; }
  /// u of an indentation, beyond the last one; that of the last below it. With u = u_f (1 + e):
  /// 6e² + 4e³ + e⁴ = 3 + (δ − δ₀) R/u_f⁴. Newton from above, where it cannot miss.
  double root(double indentation) const {
    const double end = last(), excess = 3 + (indentation - origin) * radius / (end * end * end * end);
    if (!(excess > 0)) return end;
    double e = std::min(std::sqrt(excess / 6), std::sqrt(std::sqrt(excess)));
    for (int i = 0; i < 50; ++i) {
      const double step = (e * e * (6 + e * (4 + e)) - excess) / (e * (12 + e * (12 + 4 * e)));
      e -= step;
      if (!(step > 4 * epsilon * e)) break;
    }
    return end * (1 + e);
  }
};

/// Such a branch.
struct WidthBranch {
  WidthCurve curve;
  double push[7] = {};  ///< p₀ … p₆
  double damping = 0;   ///< η
};

}  // namespace mariotte
