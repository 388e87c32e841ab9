// Truncated power series in z = t^{1/4}, in which a start of touching balls has whole exponents.
#pragma once
#include <array>
#include <cstddef>

#include "real.hpp"

namespace mariotte::reference {

inline constexpr std::size_t degree = 120;
using Series = std::array<Real, degree + 1>;

inline Series product(const Series& a, const Series& b) {
  Series c{};
  for (std::size_t i = 0; i <= degree; ++i)
    if (a[i] != 0)
      for (std::size_t j = 0; i + j <= degree; ++j) c[i + j] += a[i] * b[j];
  return c;
}

/// Square root of a series that starts with a positive term of even order; of zero, zero.
inline Series root(const Series& a) {
  std::size_t order = 0;
  while (order <= degree && a[order] == 0) ++order;
  Series r{};
  if (order > degree) return r;
  const std::size_t half = order / 2;
  r[half] = sqrt(a[order]);
  for (std::size_t n = 1; order + n <= degree; ++n) {
    Real rest = a[order + n];
    for (std::size_t i = 1; i < n; ++i) rest -= r[half + i] * r[half + n - i];
    r[half + n] = rest / (2 * r[half]);
  }
  return r;
}

/// start + ∫ a dt with t = z⁴.
inline Series integral(Real start, const Series& a) {
  Series b{};
  b[0] = start;
  for (std::size_t n = 0; n + 4 <= degree; ++n) b[n + 4] = 4 * a[n] / static_cast<Real>(n + 4);
  return b;
}

inline Real value(const Series& a, Real z) {
  Real sum = 0;
  for (std::size_t n = degree + 1; n-- > 0;) sum = sum * z + a[n];
  return sum;
}

}  // namespace mariotte::reference
