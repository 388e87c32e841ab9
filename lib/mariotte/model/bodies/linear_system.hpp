// Small symmetric systems of numbers, or of values with slopes.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "mariotte/series/dual.hpp"

namespace mariotte::model {

/// A = L D Lᵀ in place. False in `used` are rows that depend on those before, to rounding.
template <class T>
std::vector<bool> decompose_symmetric(std::span<T> a, std::size_t n) {
  constexpr double dependent = 1e-10;
  std::vector<bool> used(n, true);
  for (std::size_t i = 0; i < n; ++i) {
    const double before = series::value_of(a[i * n + i]);
    for (std::size_t j = i; j < n; ++j)
      for (std::size_t k = 0; k < i; ++k)
        if (used[k]) a[j * n + i] = a[j * n + i] - a[j * n + k] * a[i * n + k] * a[k * n + k];
    used[i] = a[i * n + i] > dependent * before;
    for (std::size_t j = i + 1; used[i] && j < n; ++j) a[j * n + i] = a[j * n + i] / a[i * n + i];
  }
  return used;
}

/// Solves A x = b by Cholesky's square-root-free method; b becomes x. Rows that depend on those before, to
/// rounding, get x = 0, and the answer is false then: other x would do as well.
template <class T>
bool solve_symmetric(std::span<T> a, std::span<T> b) {
  const std::size_t n = b.size();
  const auto used = decompose_symmetric(a, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (used[k] && used[i]) b[i] = b[i] - a[i * n + k] * b[k];
  for (std::size_t i = n; i-- > 0;) {
    if (used[i]) b[i] = b[i] / a[i * n + i];
    for (std::size_t j = i + 1; used[i] && j < n; ++j)
      if (used[j]) b[i] = b[i] - a[j * n + i] * b[j];
    if (!used[i]) b[i] = T(0.0);
  }
  return std::find(used.begin(), used.end(), false) == used.end();
}

}  // namespace mariotte::model
