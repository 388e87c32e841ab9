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

/// Coefficients 0 to `order` of a product, in as many registers. Those behind are anything.
template <int count = 1>
inline void multiply(const PushPolynomial& a, const PushPolynomial& b, int order, PushPolynomial& result) {
  using registers::width;
  constexpr int held = count * width;
  if constexpr (held < flow::most_orders + 1)
    if (order >= held) return multiply<count + 1>(a, b, order, result);
  auto shifted = registers::load_loose<count>(a.data());
  registers::LaneVector<count> sum(0.0);
#pragma GCC unroll 8
  for (int k = 0; k < width; ++k, shifted = registers::from_left(shifted))
#pragma GCC unroll 16
    for (int first = 0; first < count; ++first)
#pragma GCC unroll 16
      for (int n = first; n < count; ++n) sum.part[n] += b[first * width + k] * shifted.part[n - first];
  registers::store_loose(sum, result.data());
  std::fill(result.begin() + held, result.end(), 0.0);
}

/// Coefficient n of the root of x, of which the ones before are known.
inline double next_of_root(const PushPolynomial& x, int n, const PushPolynomial& root) {
  double sum = n % 2 == 0 ? root[n / 2] * root[n / 2] : 0;
  for (int k = 1; 2 * k < n; ++k) sum += 2 * root[k] * root[n - k];
  return 0.5 * (x[n] - sum) / root[0];
}

/// ln of a series that starts above zero: i times its coefficients are the quotient of such multiples by the
/// series.
inline void logarithm(const PushPolynomial& x, int order, PushPolynomial& result) {
  PushPolynomial share{}, multiple{};  // from order 1 on
  for (std::size_t i = 1; i < x.size(); ++i) {
    share[i - 1] = x[i] / x[0];
    multiple[i - 1] = static_cast<double>(i) * share[i - 1];
  }
  constexpr int parts = std::tuple_size_v<PushPolynomial> / registers::width;
  const auto divisor = registers::load_loose<parts>(share.data());
  auto left = registers::load_loose<parts>(multiple.data());
  result[0] = std::log(x[0]);
  for (int i = 1; i <= order; ++i) {
    const double next = left.part[0][0];
    result[i] = reciprocal.of[i] * next;
    left = registers::from_right(left) - next * divisor;
  }
}

/// a x + b y.
inline void combine(double a, const PushPolynomial& x, double b, const PushPolynomial& y,
                    PushPolynomial& result) {
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = a * x[i] + b * y[i];
}
inline void scale(double a, const PushPolynomial& x, PushPolynomial& result) {
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = a * x[i];
}

/// ∫ x from 0.
inline void integrate(const PushPolynomial& x, PushPolynomial& result) {
  result[0] = 0;
  for (std::size_t i = 1; i < x.size(); ++i) result[i] = reciprocal.of[i] * x[i - 1];
}

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
