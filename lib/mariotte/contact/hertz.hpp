// Hertz contact f = k δ^{3/2} [Acary 2003, eq. 1 with n = 3/2] and its stiffness from materials.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/contact/force.hpp"

namespace mariotte::contact {

/// Two elastic spheres, f = k δ^{3/2}.
struct Hertz {
  double stiffness;  ///< k [N/m^{3/2}]
};

/// n of f = k δⁿ.
inline double exponent(const Hertz&) {
  return 1.5;
}
/// No damper.
inline double damping(const Hertz&) {
  return 0;
}

/// k δ^{3/2}, with slopes; 0 for δ ≤ 0. The rate does not matter.
inline Force smooth_force(const Hertz& law, double indentation, double /*rate*/) {
  const double slope = law.stiffness * std::sqrt(std::max(0.0, indentation));
  return {.value = slope * indentation, .by_indentation = 1.5 * slope, .by_rate = 0};
}

/// Elastic energy (2/5) k δ^{5/2} [J].
inline double stored_energy(const Hertz& law, double indentation) {
  return 0.4 * law.stiffness * indentation * indentation * std::sqrt(indentation);
}

/// Isotropic elastic material of one body in contact.
struct Material {
  double young;    ///< E [Pa]; infinite for a rigid body
  double poisson;  ///< ν
};

/// k = (4/3) E* √R* with 1/E* = Σ(1−ν²)/E, 1/R* = Σ 1/R [Johnson 1985, §4.2]. Radii in m, ∞ for a plane.
inline double hertz_stiffness(const Material& a, double radius_a, const Material& b, double radius_b) {
  const double compliance = (1 - a.poisson * a.poisson) / a.young + (1 - b.poisson * b.poisson) / b.young;
  const double curvature = 1 / radius_a + 1 / radius_b;
  return 4.0 / 3.0 / (compliance * std::sqrt(curvature));
}

}  // namespace mariotte::contact
