// Loops whose index the compiler knows, and what the recurrences know about an order.
#pragma once
#include <type_traits>
#include <utility>

#include "mariotte/series/field.hpp"

namespace mariotte::series {

/// An order that is odd, or even, as the compiler shall know.
struct Odd {
  int k;
  MARIOTTE_SERIES_INLINE operator int() const { return k; }
};
struct Even {
  int k;
  MARIOTTE_SERIES_INLINE operator int() const { return k; }
};

MARIOTTE_SERIES_INLINE bool is_even(Odd) {
  return false;
}
MARIOTTE_SERIES_INLINE bool is_even(Even) {
  return true;
}
MARIOTTE_SERIES_INLINE bool is_even(int k) {
  return k % 2 == 0;
}

/// visit(i) for i = 0 … n − 1, each an integral_constant.
template <int n, class Visit>
MARIOTTE_SERIES_INLINE void unrolled(Visit&& visit) {
  [&]<int... i>(std::integer_sequence<int, i...>) MARIOTTE_SERIES_LAMBDA {
    (visit(std::integral_constant<int, i>()), ...);
  }
  (std::make_integer_sequence<int, n>());
}

inline constexpr int reciprocal_limit = 64;
/// 1/k.
inline constexpr auto reciprocal = [] {
  std::array<double, reciprocal_limit> of{};
  for (int k = 1; k < reciprocal_limit; ++k) of[k] = 1.0 / k;
  return of;
}();

}  // namespace mariotte::series
