// Loops whose index the compiler knows, and reciprocals.
#pragma once
#include <type_traits>
#include <utility>

#include "mariotte/series/field.hpp"

namespace mariotte::series {

/// visit(i) for i = 0 … n − 1, each an integral_constant.
template <int n, class Visit>
MARIOTTE_SERIES_INLINE void unrolled(Visit&& visit) {
  [&]<int... i>(std::integer_sequence<int, i...>) MARIOTTE_SERIES_LAMBDA {
    (visit(std::integral_constant<int, i>()), ...);
  }
  (std::make_integer_sequence<int, n>());
}

/// 1/k.
inline constexpr struct Reciprocals {
  double of[64] = {};
  constexpr Reciprocals() {
    for (int k = 1; k < 64; ++k) of[k] = 1.0 / k;
  }
} reciprocal;

}  // namespace mariotte::series
