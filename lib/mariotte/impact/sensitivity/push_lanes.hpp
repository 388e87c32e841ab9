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
class Product {
 public:
  MARIOTTE_SERIES_INLINE Lanes<N> next(const PushPolynomial& a, const Lanes<N>* x, int i) {
    return convolution(a, x, i);
  }
};
/// Where no lanes are needed, registers hold orders: as many coefficients are summed side by side.
template <>
class Product<0> {
 public:
  /// Coefficient i, the one after that of the last call.
  MARIOTTE_SERIES_INLINE Lanes<0> next(const PushPolynomial& a, const Lanes<0>* x, int i) {
    const int place = i % registers::width;
    if (place == 0) begin(a, x, i);
    sums_ += x[i].value * shifted_[place];
    return sums_[place];
  }

 private:
  using Vec = registers::Vec;
  Vec sums_;
  Vec shifted_[registers::width];  ///< the first coefficients of a behind 0, 1, … zeros

  /// What orders below i give coefficients i, i + 1, …
  MARIOTTE_SERIES_INLINE void begin(const PushPolynomial& a, const Lanes<0>* x, int i) {
    const auto from = [&](int k) { return Vec(*reinterpret_cast<const registers::Loose*>(a.data() + k)); };
    if (i == 0) {
      shifted_[0] = from(0);
      for (int k = 1; k < registers::width; ++k)
        shifted_[k] = registers::window<registers::width - 1>(Vec{}, shifted_[k - 1]);
    }
    Vec even{}, odd{};
    for (int k = 0; k < i; k += 2) {
      even += x[k].value * from(i - k);
      odd += x[k + 1].value * from(i - k - 1);
    }
    sums_ = even + odd;
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
