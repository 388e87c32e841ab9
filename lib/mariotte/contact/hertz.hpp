// The stiffness of a Hertz contact from materials and radii.
#pragma once
#include <cmath>

namespace mariotte::contact {

/// Isotropic elastic material of one body in contact.
struct Elasticity {
  double young;    ///< E [Pa]; infinite for a rigid body
  double poisson;  ///< ν
};

/// E* with 1/E* = Σ(1−ν²)/E [Pa].
inline double effective_modulus(const Elasticity& a, const Elasticity& b) {
  return 1 / ((1 - a.poisson * a.poisson) / a.young + (1 - b.poisson * b.poisson) / b.young);
}
/// R* with 1/R* = Σ 1/R [m]; the radius of a plane is infinite.
inline double effective_radius(double radius_a, double radius_b) {
  return 1 / (1 / radius_a + 1 / radius_b);
}

/// k = (4/3) E* √R* with 1/E* = Σ(1−ν²)/E, 1/R* = Σ 1/R [Johnson 1985, §4.2]. Radii in m, ∞ for a plane.
inline double hertz_stiffness(const Elasticity& a, double radius_a, const Elasticity& b, double radius_b) {
  const double compliance = (1 - a.poisson * a.poisson) / a.young + (1 - b.poisson * b.poisson) / b.young;
  const double curvature = 1 / radius_a + 1 / radius_b;
  return 4.0 / 3.0 / (compliance * std::sqrt(curvature));
}

}  // namespace mariotte::contact
