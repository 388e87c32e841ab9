// Sequences of collisions at one contact at a time.
#pragma once
#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {

/// One collision after the other, each p = −(1 + e_j) w_j/(G M⁻¹ Gᵀ)_jj at a single contact, until no gap
/// closes any more. Conserves momentum, and energy for e = 1. Exists unless the limit of a million collisions
/// is reached (status `unfinished`); for small e there may be infinitely many, which end once they are as
/// slow as rounding. What comes out depends on the order.
struct SequentialOptions {
  std::vector<double> restitution;  ///< e_j, one per contact
  long most_collisions = 1000000;
};

/// Contacts in their own order, again and again.
LawOutcome left_to_right(const Configuration& configuration, const SequentialOptions& options);

/// In the order of time, as if every contact had begun apart: the first to close collides first, ties in the
/// order of contacts. `gap` > 0 are the distances up to their size, one per contact; empty for equal ones.
LawOutcome by_event(const Configuration& configuration, const SequentialOptions& options,
                    std::vector<double> gap = {});

}  // namespace mariotte::impact
