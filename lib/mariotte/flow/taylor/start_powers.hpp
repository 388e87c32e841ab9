// Coefficients of Hertz contacts that start undeformed, for the series of their first moments.
#pragma once
#include <array>
#include <cmath>

#include "mariotte/flow/taylor/taylor_lanes.hpp"
#include "mariotte/series/field.hpp"

namespace mariotte::flow::taylor {

/// 1/(first + q k), the factors of integration in z = t^q.
struct Reciprocals {
  double of[order_limit + 1];
  constexpr Reciprocals(double first, double power) : of{} {
    for (int k = 0; k <= order_limit; ++k) of[k] = first + power * k > 0 ? 1 / (first + power * k) : 0;
  }
};

/// δ/t, its root and k (δ/t)^{3/2}, coefficient by coefficient.
template <class V>
struct StartPowers {
  using Coefficients = std::array<V, order_limit + 1>;
  V half_inverse;
  Coefficients indentation, root, force;

  /// Coefficient i of root and force, once that of the indentation is known.
  MARIOTTE_SERIES_INLINE void next(int i, const V& stiffness) {
    using std::sqrt;
    const auto& d = indentation;
    auto& s = root;
    if (i == 0) {
      s[0] = sqrt(d[0]);
      half_inverse = V(0.5) / s[0];
      force[0] = stiffness * d[0] * s[0];
      return;
    }
    const V middle = i % 2 == 0 ? s[i / 2] : V(0.0);
    V twice(0.0), left(0.0), right = d[i] * s[0];  // sums that do not wait for each other
    for (int j = 1; 2 * j < i; ++j) {
      twice = twice + s[j] * s[i - j];
      left = left + d[j] * s[i - j];
      right = right + d[i - j] * s[j];
    }
    if (i % 2 == 0) left = left + d[i / 2] * middle;
    s[i] = (d[i] - 2 * twice - middle * middle) * half_inverse;
    force[i] = stiffness * (left + right + d[0] * s[i]);
  }
};

}  // namespace mariotte::flow::taylor
