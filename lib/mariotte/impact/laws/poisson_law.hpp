// Poisson's kinetic restitution with simultaneous contacts.
#pragma once
#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {

/// Compression, 0 ≤ p^c ⊥ w^c ≥ 0, then expansion, 0 ≤ p^e − e_j p^c ⊥ w⁺ ≥ 0: a contact gives back at least
/// e_j times the impulse of compression [Glocker & Pfeiffer 1995]. Two complementarity problems.
/// Conserves momentum. Energy never grows for equal e_j, and is kept for e = 1 if no contact needs more than
/// its share in expansion. Exists for every 0 ≤ e_j ≤ 1. Where contacts are redundant p^c is not unique, and
/// with different e_j neither is the outcome.
LawOutcome poisson(const Configuration& configuration, const std::vector<double>& restitution);

}  // namespace mariotte::impact
