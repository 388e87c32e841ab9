// Moreau's global restitution.
#pragma once
#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {

/// v⁺ = −e v⁻ + (1 + e) prox(v⁻) with the projection, in the kinetic metric, onto the velocities that close
/// no gap [Moreau 1988]: one e for the whole system, which bounces off its set of admissible configurations.
/// Conserves momentum. Energy never grows, and is kept for e = 1. Exists and is unique for every 0 ≤ e ≤ 1.
/// A contact that touches but parts before the impact may go on closing afterwards, as in Newton's law.
/// The projection solves the compression of Poisson's law; scaled by 1 + e it is also Newton's law with equal
/// e_j.
LawOutcome moreau(const Configuration& configuration, double restitution);

}  // namespace mariotte::impact
