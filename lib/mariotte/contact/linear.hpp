// Linear spring f = k δ [Acary 2003, eq. 1 with n = 1].
#pragma once
#include "mariotte/contact/force.hpp"

namespace mariotte::contact {

/// A spring that cannot pull, f = k δ.
struct Linear {
  double stiffness;  ///< k [N/m]
};

/// n of f = k δⁿ.
inline double exponent(const Linear&) {
  return 1;
}
/// No damper.
inline double damping(const Linear&) {
  return 0;
}

/// k δ of either sign, with slopes; the rate does not matter.
inline Force smooth_force(const Linear& law, double indentation, double /*rate*/) {
  return {.value = law.stiffness * indentation, .by_indentation = law.stiffness, .by_rate = 0};
}

/// Elastic energy k δ²/2 [J].
inline double stored_energy(const Linear& law, double indentation) {
  return 0.5 * law.stiffness * indentation * indentation;
}

}  // namespace mariotte::contact
