// Values with slopes: what they go through gives its slopes as well, without differences.
#pragma once
#include <array>
#include <cmath>

#include "mariotte/series/field.hpp"

namespace mariotte::series {

/// A value and its slopes along n directions.
template <class V, int n>
struct Dual {
  V value;
  std::array<V, n> slope;

  Dual() = default;
  Dual(double constant) : value(constant) { slope.fill(V(0.0)); }
  Dual(const V& v, const std::array<V, n>& s) : value(v), slope(s) {}

  /// A function of a, by its value and its slope there.
  static Dual chain(const Dual& a, const V& value, const V& rate) {
    Dual result;
    result.value = value;
    for (int i = 0; i < n; ++i) result.slope[i] = a.slope[i] * rate;
    return result;
  }
  /// A function of a and b, by its value and its slopes along both.
  static Dual chain(const Dual& a, const Dual& b, const V& value, const V& rate_a, const V& rate_b) {
    Dual result;
    result.value = value;
    for (int i = 0; i < n; ++i) result.slope[i] = a.slope[i] * rate_a + b.slope[i] * rate_b;
    return result;
  }

  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual result;
    result.value = a.value + b.value;
    for (int i = 0; i < n; ++i) result.slope[i] = a.slope[i] + b.slope[i];
    return result;
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    Dual result;
    result.value = a.value - b.value;
    for (int i = 0; i < n; ++i) result.slope[i] = a.slope[i] - b.slope[i];
    return result;
  }
  friend Dual operator-(const Dual& a) { return chain(a, -a.value, V(-1.0)); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return chain(a, b, a.value * b.value, b.value, a.value);
  }
  friend Dual operator*(double a, const Dual& b) { return chain(b, a * b.value, V(a)); }
  friend Dual operator*(const Dual& a, double b) { return b * a; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const V inverse = V(1.0) / b.value, quotient = a.value * inverse;
    return chain(a, b, quotient, inverse, -(quotient * inverse));
  }
  friend Dual sqrt(const Dual& a) {
    using std::sqrt;
    const V root = sqrt(a.value);
    return chain(a, root, V(0.5) / root);
  }
  friend Dual exp(const Dual& a) {
    using std::exp;
    const V power = exp(a.value);
    return chain(a, power, power);
  }
  friend Dual sin(const Dual& a) {
    using std::cos, std::sin;
    return chain(a, sin(a.value), cos(a.value));
  }
  friend Dual cos(const Dual& a) {
    using std::cos, std::sin;
    return chain(a, cos(a.value), -sin(a.value));
  }
  friend bool operator<(const Dual& a, double b) { return a.value < b; }
  friend bool operator>(const Dual& a, double b) { return a.value > b; }
  /// The exponent has no slopes.
  friend Dual pow(const Dual& a, const Dual& exponent) {
    using std::pow;
    const V less = pow(a.value, exponent.value - V(1.0));
    return chain(a, less * a.value, exponent.value * less);
  }
};

/// Without slopes.
inline double value_of(double a) {
  return a;
}
template <class V, int n>
V value_of(const Dual<V, n>& a) {
  return a.value;
}

}  // namespace mariotte::series
