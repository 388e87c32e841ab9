// Viscoelastic contact f = max(0, k δⁿ + c δ^{n−1} δ̇) [Acary 2003, eq. 26].
//
// The force is δ^{n−1} (k δ + c δ̇), so its sign is that of the *load* k δ + c δ̇: the contact carries
// force iff δ > 0 and the load is positive. It lets go while still indented, and is *slack* from then on
// until the load turns positive again or the gap opens.
#pragma once
#include <cmath>

#include "mariotte/contact/force.hpp"

namespace mariotte::contact {

/// A spring and a damper of one exponent, f = k δⁿ + c δⁿ⁻¹ δ̇.
struct Viscoelastic {
  double stiffness;       ///< k [N/m^n]
  double damping = 0;     ///< c ≥ 0 [N s/m^n]
  double exponent = 1.5;  ///< n ≥ 1
};

/// n of f = k δⁿ + c δⁿ⁻¹ δ̇.
inline double exponent(const Viscoelastic& law) {
  return law.exponent;
}
/// c [N s/m^n].
inline double damping(const Viscoelastic& law) {
  return law.damping;
}

/// δ^{n−1} without pow for the exponents that occur most.
inline double contact_width(double exponent, double indentation) {
  if (exponent == 1.5) return std::sqrt(indentation);
  if (exponent == 1) return 1;
  return std::pow(indentation, exponent - 1);
}

/// δ^{n−1} (k δ + c δ̇) of either sign, with slopes; for n > 1, 0 for δ ≤ 0.
/// The slope by indentation is unbounded towards δ = 0 for n < 2 and left out (0) at δ = 0 itself.
inline Force smooth_force(const Viscoelastic& law, double indentation, double rate) {
  if (law.exponent > 1 && !(indentation > 0)) return {.value = 0, .by_indentation = 0, .by_rate = 0};
  const double load = law.stiffness * indentation + law.damping * rate;
  const double width = contact_width(law.exponent, indentation);
  const double bend = law.exponent > 1 ? (law.exponent - 1) * width * load / indentation : 0;
  return {
      .value = width * load, .by_indentation = bend + width * law.stiffness, .by_rate = width * law.damping};
}

/// Elastic energy k δ^{n+1}/(n+1) [J].
inline double stored_energy(const Viscoelastic& law, double indentation) {
  return law.stiffness * contact_width(law.exponent, indentation) * indentation * indentation /
         (law.exponent + 1);
}

}  // namespace mariotte::contact
