// Adhesive, damped contact of a spherical tip with a plane [Cheng 2002, eq. 1]:
//
//     F = √r K δ^{3/2} (1 − C_H ṅ) − 2π f₀ √(r δ) (1 + C_A ṅ),    δ = −n > 0
//
// a Hertz force and a ring of adhesion on the edge of the contact, each with its own damping. ṅ is the normal
// velocity of the tip, so the indentation rate is −ṅ. Both dampings take energy for either sign of ṅ.
#pragma once
#include <cmath>
#include <numbers>

namespace mariotte::contact {

/// One tip's law of force: Hertz stiffness, adhesion, and a damping of each.
struct BrachDunn {
  double stiffness = 0;         ///< √r K [N/m^{3/2}]
  double adhesion = 0;          ///< 2π f₀ √r [N/m^{1/2}]
  double damping_hertz = 0;     ///< C_H [s/m]
  double damping_adhesion = 0;  ///< C_A [s/m]
};

/// The force without its factor √δ, which has the same sign: K√r δ (1 − C_H ṅ) − 2π f₀√r (1 + C_A ṅ).
template <class T>
T pressure(const BrachDunn& law, const T& indentation, const T& velocity) {
  return law.stiffness * indentation * (1.0 - law.damping_hertz * velocity) -
         law.adhesion * (1.0 + law.damping_adhesion * velocity);
}

/// The same without the signs of its terms: what errors of the pressure at such a speed are relative to.
inline double pressure_size(const BrachDunn& law, double indentation, double speed) {
  return law.stiffness * indentation * (1 + law.damping_hertz * speed) +
         law.adhesion * (1 + law.damping_adhesion * speed);
}

/// Force, positive away from the plane; zero for δ ≤ 0.
template <class T>
T normal_force(const BrachDunn& law, const T& indentation, const T& velocity) {
  using std::sqrt;
  if (!(indentation > 0.0)) return T(0);
  return sqrt(indentation) * pressure(law, indentation, velocity);
}

/// Energy of the undamped force: (2/5) √r K δ^{5/2} − (4π/3) f₀ √r δ^{3/2} [J]; negative in the well.
inline double stored_energy(const BrachDunn& law, double indentation) {
  const double root = std::sqrt(indentation);
  return indentation * root * (0.4 * law.stiffness * indentation - 2.0 / 3.0 * law.adhesion);
}

/// Power of Hertz damping, never positive [W]; zero for δ ≤ 0.
template <class T>
T hertz_damping_power(const BrachDunn& law, const T& indentation, const T& velocity) {
  using std::sqrt;
  if (!(indentation > 0.0)) return T(0);
  return -law.stiffness * law.damping_hertz * (indentation * sqrt(indentation) * (velocity * velocity));
}
/// Power of adhesion damping, never positive [W]; zero for δ ≤ 0.
template <class T>
T adhesion_damping_power(const BrachDunn& law, const T& indentation, const T& velocity) {
  using std::sqrt;
  if (!(indentation > 0.0)) return T(0);
  return -law.adhesion * law.damping_adhesion * (sqrt(indentation) * (velocity * velocity));
}

/// Indentation at which the tip can rest, 2π f₀ / K [m]: the Hertz force balances the ring.
inline double rest_indentation(const BrachDunn& law) {
  return law.adhesion / law.stiffness;
}

/// What the law follows from [Cheng 2002, Table 1].
struct Surface {
  double stiffness = 0;  ///< K = (4/3) E* [Pa]
  double adhesion = 0;   ///< work of adhesion w_A [J/m²]
};

/// f₀ = (9 K r w_A² / 2π)^{1/3} [N/m] [Cheng 2002, eq. 2].
inline double line_force(const Surface& surface, double radius) {
  return std::cbrt(9 * surface.stiffness * radius * surface.adhesion * surface.adhesion /
                   (2 * std::numbers::pi));
}

/// The law of a tip with this radius [m] and damping coefficients [s/m].
inline BrachDunn brach_dunn(const Surface& surface, double radius, double damping_hertz,
                            double damping_adhesion) {
  const double root = std::sqrt(radius);
  return {.stiffness = root * surface.stiffness,
          .adhesion = 2 * std::numbers::pi * line_force(surface, radius) * root,
          .damping_hertz = damping_hertz,
          .damping_adhesion = damping_adhesion};
}

/// Prefactors of the damping coefficients, reconstructed: the printed ones fit no figure of the paper.
inline constexpr double hertz_prefactor = 1.5120513740747573e-6;  ///< c_H = (4π⁸/5)^{−3/2}
inline constexpr double adhesion_prefactor = 31.77899017804106;   ///< c_A = (3π⁸/5)^{2/5}

/// C_H = ζ c_H v₀^{−1/4} X^{−3/4}, X = f₀³ K^{−5/2} r^{−3} ρ^{−1/2} [s/m]: [Cheng 2002, eq. 4] with the
/// exponents that dimensions demand. v₀ is the incident normal speed of the mass centre.
inline double hertz_damping(double zeta, const Surface& surface, double radius, double density, double speed,
                            double prefactor = hertz_prefactor) {
  const double f = line_force(surface, radius);
  const double x =
      f * f * f / (std::pow(surface.stiffness, 2.5) * radius * radius * radius) / std::sqrt(density);
  return zeta * prefactor * std::pow(speed, -0.25) * std::pow(x, -0.75);
}

/// C_A = ζ c_A v₀^{−1/4} X^{−3/4}, X = f₀^{−2/5} K^{9/10} r^{2/5} ρ^{−1/2} [s/m]: [Cheng 2002, eq. 5],
/// likewise.
inline double adhesion_damping(double zeta, const Surface& surface, double radius, double density,
                               double speed, double prefactor = adhesion_prefactor) {
  const double x = std::pow(line_force(surface, radius), -0.4) * std::pow(surface.stiffness, 0.9) *
                   std::pow(radius, 0.4) / std::sqrt(density);
  return zeta * prefactor * std::pow(speed, -0.25) * std::pow(x, -0.75);
}

}  // namespace mariotte::contact
