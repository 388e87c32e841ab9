// Impact laws with Coulomb friction for one contact in the plane: the impulse that each gives. Without
// friction, and wherever slip goes on in one direction to the end, all are the same.
#pragma once
#include "mariotte/impact/laws/frictional_contact.hpp"

namespace mariotte::impact {

/// Newton's restitution, w⁺ = −e w⁻, with Coulomb's law for the impulse as a whole, in the direction of the
/// slip at the end: −p_t ∈ μ p_n Sgn u⁺ [Whittaker 1904; Kane & Levinson 1985]. Exists and is unique. Energy
/// may grow where slip ends or turns round.
InContact newton(const FrictionalContact& contact, double restitution);

/// Poisson's: after the impulse of compression comes e times as much, with Coulomb's law at every instant of
/// it [Routh 1905]. Energy never grows for e ≤ 1.
InContact poisson(const FrictionalContact& contact, double restitution);

/// Moreau's: (1 + e) times the impulse of the perfectly plastic impact, so that Coulomb's law holds for the
/// velocity u⁺ + e u⁻ [Moreau 1988]. Energy never grows for e ≤ 1, but slip that a plastic impact stops comes
/// back with e times its speed.
InContact moreau(const FrictionalContact& contact, double restitution);

/// Stronge's: the normal force gives back e² of the work that compression did on it, with Coulomb's law at
/// every instant [Stronge 1990]. Energy never grows for e ≤ 1. This is the limit of stiff contacts whose
/// friction is rigid.
InContact stronge(const FrictionalContact& contact, double restitution);

}  // namespace mariotte::impact
