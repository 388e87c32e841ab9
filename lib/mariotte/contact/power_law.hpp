// The power laws f = max(0, k δⁿ + c δⁿ⁻¹ δ̇) [Acary 2003, eq. 1 and 26]: linear springs, Hertz contacts, and
// both with a damper.
//
// The force is δⁿ⁻¹ (k δ + c δ̇), so its sign is that of the *load* k δ + c δ̇: the contact carries force iff
// δ > 0 and the load is positive. A damped contact lets go while still indented, and is *slack* from then on
// until the load turns positive again or the gap opens.
#pragma once
#include <cmath>

#include "mariotte/contact/force.hpp"

namespace mariotte::contact {

/// f = k δⁿ + c δⁿ⁻¹ δ̇, cut off where it would pull.
struct PowerLaw {
  double stiffness;       ///< k > 0 [N/m^n]
  double damping = 0;     ///< c ≥ 0 [N s/m^n]
  double exponent = 1.5;  ///< n ≥ 1
};

/// The spring f = k δ, k in N/m.
struct Linear : PowerLaw {
  explicit constexpr Linear(double k) : PowerLaw{.stiffness = k, .exponent = 1} {}
};

/// Two elastic spheres, f = k δ^{3/2}, k in N/m^{3/2} [Johnson 1985, §4.2].
struct Hertz : PowerLaw {
  explicit constexpr Hertz(double k) : PowerLaw{.stiffness = k, .exponent = 1.5} {}
};

/// Any member by its three numbers.
using Viscoelastic = PowerLaw;

/// "linear", "hertz" or "viscoelastic": the name of a member.
inline const char* name(const PowerLaw& law) {
  if (law.damping == 0 && law.exponent == 1) return "linear";
  return law.damping == 0 && law.exponent == 1.5 ? "hertz" : "viscoelastic";
}

/// δⁿ⁻¹ without pow for the exponents that occur most.
inline double contact_width(double exponent, double indentation) {
  if (exponent == 1.5) return std::sqrt(indentation);
  if (exponent == 1) return 1;
  return std::pow(indentation, exponent - 1);
}

/// δⁿ⁻¹ (k δ + c δ̇) of either sign, with slopes; for n > 1, 0 for δ ≤ 0. The slope by indentation of a damped
/// contact is unbounded towards δ = 0 for n < 2 and left out (0) at δ = 0 itself.
inline Force smooth_force(const PowerLaw& law, double indentation, double rate) {
  const double n = law.exponent;
  if (n > 1 && !(indentation > 0)) return {.value = 0, .by_indentation = 0, .by_rate = 0};
  const double width = contact_width(n, indentation);
  const double bend = law.damping > 0 && n > 1 ? (n - 1) * law.damping * rate / indentation : 0;
  return {.value = width * (law.stiffness * indentation + law.damping * rate),
          .by_indentation = width * (n * law.stiffness + bend),
          .by_rate = width * law.damping};
}

/// k δ + c δ̇, which has the sign of the force, with slopes.
inline Force load(const PowerLaw& law, double indentation, double rate) {
  return {.value = law.stiffness * indentation + law.damping * rate,
          .by_indentation = law.stiffness,
          .by_rate = law.damping};
}

/// Elastic energy k δⁿ⁺¹/(n+1) [J].
inline double stored_energy(const PowerLaw& law, double indentation) {
  return law.stiffness * contact_width(law.exponent, indentation) * indentation * indentation /
         (law.exponent + 1);
}

/// True of a law with a damper.
inline bool dissipates(const PowerLaw& law) {
  return law.damping > 0;
}

/// Indentation at which the contact carries a force at rest [m].
inline double static_indentation(const PowerLaw& law, double force) {
  return std::pow(force / law.stiffness, 1 / law.exponent);
}

}  // namespace mariotte::contact
