// Units in which a scene's numbers are of order one.
#pragma once
#include <cmath>

namespace mariotte {

/// One dimensionless unit in the scene's own units. Mass and velocity are powers of two, so that masses and
/// velocities are converted exactly; length makes one chosen stiffness exactly 1, so that the dimensionless
/// scene does not depend on how stiff its contacts are; time = length / velocity.
struct Scale {
  double mass = 1;
  double velocity = 1;
  double length = 1;
  double time = 1;
  double refinement = 1;  ///< share of an accuracy that phases may spend

  double momentum() const { return mass * velocity; }
  double energy() const { return mass * velocity * velocity; }
  double force() const { return energy() / length; }
};

/// Largest power of two not above a positive finite value.
inline double power_of_two_below(double value) {
  return std::ldexp(1.0, std::ilogb(value));
}

/// q^{1/(n+1)}, homogeneous to the last bit for n = 1 and 3/2: multiplying q by 4^m or 32^m multiplies the
/// result by exactly 2^m or 4^m. 0 and ∞ are their own roots.
inline double natural_root(double q, double exponent) {
  if (!(q > 0) || std::isinf(q) || exponent == 1) return std::sqrt(q);
  if (exponent != 1.5) return std::pow(q, 1 / (exponent + 1));
  const int fives = static_cast<int>(std::floor(std::ilogb(q) / 5.0));
  return std::ldexp(std::pow(std::ldexp(q, -5 * fives), 0.4), 2 * fives);
}

}  // namespace mariotte
