// Slopes of a microbody that touches its plane without any slip.
#pragma once
#include "mariotte/impact/sensitivity/microbody_variation.hpp"

namespace mariotte::impact {

/// Where its first tip sticks at the start, next to rest any slip rests at once: friction takes the slopes of
/// the slip away, by the impulse J with W J = −u and the mobility W of the tip along the plane.
void rest_at_start(const model::MicrobodySystem& system, const std::vector<ShiftedBodies>& shifted,
                   ConstState x0, SlopeMatrix& start);

/// Where its first tip starts to slip instead: by parameter, whether it gives the tip a slip at once, against
/// which friction would turn. Slopes by these have one side.
std::vector<bool> slips_at_start(const model::MicrobodySystem& system,
                                 const std::vector<ShiftedBodies>& shifted, ConstState x0,
                                 const SlopeMatrix& start);

}  // namespace mariotte::impact
