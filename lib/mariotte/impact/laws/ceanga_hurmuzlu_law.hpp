// The law of Ceanga & Hurmuzlu: constant impulse correlation ratios, and an energetic coefficient of
// restitution at each contact.
#pragma once
#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {

/// Parameters of the law.
struct CorrelationLaw {
  std::vector<double> restitution;  ///< energetic e_j, 0 ≤ e_j ≤ 1, one per contact
  std::vector<double> direction;    ///< r: impulses up to their size; ratios r_j/r_{j+1} are the ICRs
};

/// All impulses grow together, p = r s, from s = 0, with gap rates w(s) = w⁻ + s G M⁻¹ Gᵀ r
/// [Ceanga & Hurmuzlu 2001]. A contact takes up energy while its gap closes and gives energy back while it
/// opens. e_j² of what contact j takes up can be given back, at any contact, because the ratios tie the
/// contacts together. This is a reconstruction from how later papers describe the law [Acary 2003]. The
/// impact ends when nothing is left:
///
///   Σ_j r_j ∫₀ˢ (e_j² max(0, −w_j) − max(0, w_j)) ds = 0,  at the first s > 0 at which this sum falls to 0
///
/// For two bodies this is w⁺ = −e w⁻. The paper treats triplets of balls; this is the same rule for any
/// number of contacts. Conserves momentum; loses 1 − e_j² of the energy that contact j takes up, so none for
/// e = 1. Then it is the multiple-impact law with energy ratio 1.
/// Exists wherever something approaches along r, and is unique; not always admissible, and says so: with
/// small e_j the energy is used up while some contact still closes.
/// Throws InvalidParameter for restitutions outside of the above, or a direction that is not finite.
LawOutcome ceanga_hurmuzlu(const Configuration& configuration, const CorrelationLaw& law);

}  // namespace mariotte::impact
