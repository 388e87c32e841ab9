// Numbers of several parameters side by side, for one instruction set.
#pragma once
#include "mariotte/impact/sensitivity/push_polynomials.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

/// One number for each of several parameters, in N registers.
template <int N>
struct Lanes : registers::LaneVector<N> {
  using Base = registers::LaneVector<N>;
  using Base::Base;
  static constexpr Index count = N * registers::width;

  Lanes(const Base& a) : Base(a) {}
  double& operator[](Index i) { return reinterpret_cast<double*>(this->part)[i]; }
  double operator[](Index i) const { return reinterpret_cast<const double*>(this->part)[i]; }
  MARIOTTE_SERIES_INLINE Lanes& operator+=(const Base& a) { return *this = *this + a; }
};

/// Of one parameter alone.
template <>
struct Lanes<0> {
  static constexpr Index count = 1;
  double value;

  Lanes() = default;
  Lanes(double a) : value(a) {}
  operator double() const { return value; }
  double& operator[](Index) { return value; }
  double operator[](Index) const { return value; }
  MARIOTTE_SERIES_INLINE Lanes& operator+=(double a) { return *this = value + a; }
};

MARIOTTE_SERIES_INLINE Lanes<0> magnitude(Lanes<0> a) {
  return std::abs(a.value);
}
template <int N>
MARIOTTE_SERIES_INLINE Lanes<N> magnitude(const Lanes<N>& a) {
  return registers::each<N>([&](int i) { return registers::magnitude(a.part[i]); });
}
MARIOTTE_SERIES_INLINE Lanes<0> largest(Lanes<0> a, Lanes<0> b) {
  return a.value > b.value ? a : b;
}
template <int N>
MARIOTTE_SERIES_INLINE Lanes<N> largest(const Lanes<N>& a, const Lanes<N>& b) {
  return registers::each<N>([&](int i) { return registers::largest(a.part[i], b.part[i]); });
}

/// Σ a_{i−k} x_k; two sums, which need not wait for each other.
template <int N>
MARIOTTE_SERIES_INLINE Lanes<N> convolution(const PushPolynomial& a, const Lanes<N>* x, int i) {
  registers::Vec even[N] = {}, odd[N] = {};
  int k = 0;
#pragma GCC unroll 2
  for (; k < i; k += 2) {
    const auto first = registers::splat(a[i - k]), second = registers::splat(a[i - k - 1]);
    for (int n = 0; n < N; ++n) {
      even[n] += first * x[k].part[n];
      odd[n] += second * x[k + 1].part[n];
    }
  }
  if (k == i)
    for (int n = 0; n < N; ++n) even[n] += registers::splat(a[0]) * x[i].part[n];
  return registers::each<N>([&](int n) { return even[n] + odd[n]; });
}

/// Coefficients 0, 1, … of a product with a series that becomes known order by order.
template <int N>
struct Product {
  MARIOTTE_SERIES_INLINE Lanes<N> next(const PushPolynomial& a, const Lanes<N>* x, int i, int /*orders*/) {
    return convolution(a, x, i);
  }
};
/// Where no lanes are needed, registers hold orders.
template <>
struct Product<0> : GrowingProduct {
  MARIOTTE_SERIES_INLINE Lanes<0> next(const PushPolynomial& a, const Lanes<0>* x, int i, int orders) {
    return GrowingProduct::next(a.data(), x[i], i, orders);
  }
};

/// The value at `place` of x_first zᶠⁱʳˢᵗ + … + x_last zˡᵃˢᵗ over zᶠⁱʳˢᵗ.
template <int N>
MARIOTTE_SERIES_INLINE Lanes<N> value_at(double place, const Lanes<N>* x, int first, int last) {
  Lanes<N> sum = x[last];
  for (int i = last - 1; i >= first; --i) sum = place * sum + x[i];
  return sum;
}

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
