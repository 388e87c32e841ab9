#include "linear_triplet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mariotte::stiffness_study {
namespace {

using Real = long double;

/// a sin(ω₁ t)/ω₁ + b sin(ω₂ t)/ω₂ and its integrals, with ω₁ < ω₂.
struct TwoModes {
  Real a, b, slow, fast;

  Real value(Real t) const { return a * std::sin(slow * t) / slow + b * std::sin(fast * t) / fast; }
  Real slope(Real t) const { return a * std::cos(slow * t) + b * std::cos(fast * t); }
  Real integral(Real t) const {
    return a * versine(slow * t) / (slow * slow) + b * versine(fast * t) / (fast * fast);
  }
  static Real versine(Real x) { return 2 * std::sin(x / 2) * std::sin(x / 2); }

  /// Smallest positive zero of an overlap that starts positive. The slow sine outweighs the fast one until
  /// shortly before π/ω₁; from there the fast one is sampled finely enough to part its zeros.
  Real first_zero() const {
    const Real pi = std::numbers::pi_v<Real>;
    const Real weight = std::abs(b) * slow / (std::abs(a) * fast);
    Real before = weight < 1 ? (1 - 1e-9L) * (pi - std::asin(weight)) / slow : 0;
    const Real step = 0.01L / fast;
    while (value(before + step) > 0) before += step;
    Real after = before + step;
    for (int i = 0; i < 80; ++i) {
      const Real middle = (before + after) / 2;
      (value(middle) > 0 ? before : after) = middle;
    }
    return (before + after) / 2;
  }
};

/// Impulse per unit stiffness of the contact that stays closed with overlap x and rate r, alone with two
/// balls of which the frequency is ω, until it opens.
Real parting(Real x, Real r, Real frequency) {
  const Real angle = std::atan2(x * frequency, -r);
  return x * std::sin(angle) / frequency + r * TwoModes::versine(angle) / (frequency * frequency);
}

}  // namespace

std::vector<double> linear_triplet(double ratio) {
  const Real k = ratio, s = std::sqrt(k * k - k + 1);
  // κ+1−s and κ−1−s cancel for large κ; (κ+1)² − s² = 3κ and βγ = −κ do not.
  const Real slow = std::sqrt(3 * k / (k + 1 + s)), fast = std::sqrt(k + 1 + s);
  const Real beta = k - 1 + s, gamma = -k / beta;
  const TwoModes first{beta / (2 * s), -gamma / (2 * s), slow, fast};
  const TwoModes second{1 / (2 * s), -1 / (2 * s), slow, fast};
  const Real opens = first.first_zero(), other = second.first_zero(), t = std::min(opens, other);
  Real p1 = first.integral(t), p2 = k * second.integral(t);
  if (opens < other)
    p2 += k * parting(second.value(t), second.slope(t), std::sqrt(2 * k));
  else
    p1 += parting(first.value(t), first.slope(t), std::sqrt(2.0L));
  return {static_cast<double>(1 - p1), static_cast<double>(p1 - p2), static_cast<double>(p2)};
}

}  // namespace mariotte::stiffness_study
