// One contact with Coulomb friction in the plane at the instant of an impact, as impact laws see it.
#pragma once

namespace mariotte::impact {

/// Components along the normal, from a to b, and along the tangent e_z × n.
struct InContact {
  double normal = 0, tangential = 0;
};

/// Rigid bodies that touch at one place. An impulse p on b, and its opposite on a, changes the velocity of b
/// on a there by W p.
struct FrictionalContact {
  double nn = 1, nt = 0, tt = 1;  ///< W, symmetric and positive [1/kg]
  InContact velocity = {};        ///< before the impact, normal < 0 [m/s]
  double friction = 0;            ///< μ ≥ 0
};

/// Velocity of b on a after an impulse.
InContact velocity_after(const FrictionalContact& contact, const InContact& impulse);

/// By how much an impulse changes the kinetic energy: p · (u⁻ + u⁺)/2.
double energy_change(const FrictionalContact& contact, const InContact& impulse);

/// Throws InvalidParameter unless W is positive, the gap closes, and μ and the restitution are ≥ 0.
void validate(const FrictionalContact& contact, double restitution);

}  // namespace mariotte::impact
