// Newton's kinematic restitution with simultaneous contacts.
#pragma once
#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {

/// 0 ≤ p_j ⊥ w⁺_j + e_j w⁻_j ≥ 0 with gap rates w: a contact that pushes leaves with e_j times its approach,
/// one that does not may leave faster [Glocker & Pfeiffer 1995]. One complementarity problem.
/// Conserves momentum. Kinetic energy is kept for e = 1 and never grows for equal e_j; for different ones it
/// can grow. Exists for every 0 ≤ e_j ≤ 1; velocities are unique. A contact that touches but parts before the
/// impact, w⁻_j > 0, may go on closing afterwards with up to e_j w⁻_j: then the outcome is not admissible.
LawOutcome newton(const Configuration& configuration, const std::vector<double>& restitution);

}  // namespace mariotte::impact
