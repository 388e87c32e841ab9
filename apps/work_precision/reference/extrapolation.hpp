// One step of Gragg–Bulirsch–Stoer extrapolation in quadruple precision: the explicit midpoint rule with
// 2, 4, … 20 substeps, extrapolated in h² to order 20 [Hairer, Nørsett & Wanner 1993, II.9].
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include "real.hpp"

namespace mariotte::reference {

template <std::size_t N>
struct Extrapolated {
  std::array<Real, N> x;
  Real error;  ///< difference of the last two columns, far above the error of x
};

template <std::size_t N, class Derivative>
std::array<Real, N> midpoint(const Derivative& derivative, const std::array<Real, N>& x, Real h,
                             int substeps) {
  const Real step = h / substeps;
  auto before = x, now = x;
  const auto first = derivative(x);
  for (std::size_t i = 0; i < N; ++i) now[i] += step * first[i];
  for (int n = 1; n < substeps; ++n) {
    const auto slope = derivative(now);
    for (std::size_t i = 0; i < N; ++i) before[i] += 2 * step * slope[i];
    std::swap(before, now);
  }
  return now;
}

template <std::size_t N, class Derivative>
Extrapolated<N> extrapolate(const Derivative& derivative, const std::array<Real, N>& x, Real h) {
  constexpr int columns = 10;
  std::array<std::array<Real, N>, columns> table;  // the current row, newest entry of each column
  Extrapolated<N> result{x, 0};
  for (int row = 0; row < columns; ++row) {
    auto entry = midpoint(derivative, x, h, 2 * (row + 1));
    for (int column = 0; column < row; ++column) {
      const Real ratio = static_cast<Real>(row + 1) / (row - column);
      const auto above = table[column];
      table[column] = entry;
      for (std::size_t i = 0; i < N; ++i) entry[i] += (entry[i] - above[i]) / (ratio * ratio - 1);
    }
    table[row] = entry;
  }
  result.x = table[columns - 1];
  for (std::size_t i = 0; i < N; ++i)
    result.error = std::max(result.error, abs(table[columns - 1][i] - table[columns - 2][i]));
  return result;
}

}  // namespace mariotte::reference
