// Polynomials of the motion in a step, for one instruction set.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/flow/push_series.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

using flow::PushPolynomial;
using flow::PushSeries;
namespace registers = flow::taylor::MARIOTTE_INSTRUCTION_SET;
using series::reciprocal;

inline double value_at(double place, const PushPolynomial& x, int last) {
  double sum = x[last];
  for (int i = last - 1; i >= 0; --i) sum = place * sum + x[i];
  return sum;
}

typedef double Loose __attribute__((vector_size(MARIOTTE_VECTOR_BYTES), aligned(8)));
inline registers::Vec load(const double* from) {
  return *reinterpret_cast<const Loose*>(from);
}

/// As many registers of coefficients of a product, each by itself; `a` stands behind zeros.
template <int count>
inline void multiply_registers(const double* a, const PushPolynomial& b, PushPolynomial& result) {
  using registers::width;
  registers::Vec sum[count] = {};
#pragma GCC unroll 64
  for (int k = 0; k < count * width; ++k)
#pragma GCC unroll 64
    for (int n = k / width; n < count; ++n) sum[n] += b[k] * load(a + n * width - k);
  for (int n = 0; n < count; ++n) *reinterpret_cast<Loose*>(&result[n * width]) = sum[n];
}

/// Coefficients 0 to `order` of a product. Those behind, as far as registers are whole, are anything.
template <int count = 1>
inline void multiply(const PushPolynomial& a, const PushPolynomial& b, int order, PushPolynomial& result) {
  constexpr int held = count * registers::width;
  if constexpr (held < flow::most_orders + 1)
    if (order >= held) return multiply<count + 1>(a, b, order, result);
  double shifted[registers::width + held] = {};
  std::copy_n(a.begin(), held, shifted + registers::width);
  multiply_registers<count>(shifted + registers::width, b, result);
}

/// A product with a series that becomes known order by order: each gives later ones its part at once.
class GrowingProduct {
 public:
  /// Coefficient i of a x, the one after that of the last call; no more than `orders` are wanted.
  MARIOTTE_SERIES_INLINE double next(const double* a, double x, int i, int orders) {
    using registers::width;
    if (i == 0) std::fill(std::begin(later_), std::end(later_), registers::Vec{});
    const int count = (orders - i - 1) / width + 1;
    for (int n = 0; n < count; ++n) later_[n] += x * load(a + n * width);
    const double found = later_[0][0];
    for (int n = 0; n < count; ++n) later_[n] = registers::window<1>(later_[n], later_[n + 1]);
    return found;
  }

 private:
  registers::Vec later_[sizeof(PushPolynomial) / sizeof(registers::Vec) + 1];  ///< what later ones have
};

/// Coefficient n of the root of x, of which the ones before are known.
inline double next_of_root(const PushPolynomial& x, int n, const PushPolynomial& root) {
  double sum = n % 2 == 0 ? root[n / 2] * root[n / 2] : 0;
  for (int k = 1; 2 * k < n; ++k) sum += 2 * root[k] * root[n - k];
  return 0.5 * (x[n] - sum) / root[0];
}

/// ln of a series that starts above zero.
inline void logarithm(const PushPolynomial& x, int order, PushPolynomial& result) {
  PushPolynomial slope, share;  // i times coefficient i, and x over its first
  for (int i = 1; i <= order; ++i) share[i] = x[i] / x[0];
  result[0] = std::log(x[0]);
  for (int i = 1; i <= order; ++i) {
    double even = i * share[i], odd = 0;
    int k = 1;
    for (; k + 1 < i; k += 2) {
      even -= slope[k] * share[i - k];
      odd -= slope[k + 1] * share[i - k - 1];
    }
    if (k < i) even -= slope[k] * share[i - k];
    slope[i] = even + odd;
    result[i] = reciprocal.of[i] * slope[i];
  }
}

/// a x + b y.
inline void combine(double a, const PushPolynomial& x, double b, const PushPolynomial& y, int order,
                    PushPolynomial& result) {
  for (int i = 0; i <= order; ++i) result[i] = a * x[i] + b * y[i];
}
inline void scale(double a, const PushPolynomial& x, int order, PushPolynomial& result) {
  for (int i = 0; i <= order; ++i) result[i] = a * x[i];
}

/// ∫ x from 0, to order + 1.
inline void integrate(const PushPolynomial& x, int order, PushPolynomial& result) {
  result[0] = 0;
  for (int i = 0; i <= order; ++i) result[i + 1] = reciprocal.of[i + 1] * x[i];
}

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
