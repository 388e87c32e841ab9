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

/// Coefficients 0 to `order` of a product, several of them side by side.
inline void multiply(const PushPolynomial& a, const PushPolynomial& b, int order, PushPolynomial& result) {
  using registers::width;
  typedef double Loose __attribute__((vector_size(MARIOTTE_VECTOR_BYTES), aligned(8)));
  constexpr int room = flow::most_orders + 1 + 2 * width;
  double shifted[room] = {};  // a behind zeros
  for (int i = 0; i <= order; ++i) shifted[width + i] = a[i];
  for (int first = 0; first <= order; first += width) {
    registers::Vec even{}, odd{};
    const auto part = [&](int k) {
      return b[k] * *reinterpret_cast<const Loose*>(shifted + width + first - k);
    };
    const int last = std::min(order, first + width - 1);
    int k = 0;
    for (; k < last; k += 2) even += part(k), odd += part(k + 1);
    if (k == last) even += part(k);
    even += odd;
    for (int i = first; i <= last; ++i) result[i] = even[i - first];
  }
}

inline void divide(const PushPolynomial& a, const PushPolynomial& b, int order, PushPolynomial& result) {
  const double share = 1 / b[0];
  for (int i = 0; i <= order; ++i) {
    double even = a[i], odd = 0;
    int k = 0;
    for (; k + 1 < i; k += 2) {
      even -= b[i - k] * result[k];
      odd -= b[i - k - 1] * result[k + 1];
    }
    if (k < i) even -= b[i - k] * result[k];
    result[i] = share * (even + odd);
  }
}

/// ln of a series that starts above zero.
inline void logarithm(const PushPolynomial& x, int order, PushPolynomial& result) {
  const double share = 1 / x[0];
  result[0] = std::log(x[0]);
  for (int i = 1; i <= order; ++i) {
    double sum = 0;
    for (int k = 1; k < i; ++k) sum += k * result[k] * x[i - k];
    result[i] = share * (x[i] - reciprocal.of[i] * sum);
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
