// Slopes of a microbody that touches its plane without any slip.
#pragma once
#include "mariotte/impact/sensitivity/microbody_variation.hpp"

namespace mariotte::impact {

/// Where its first tip sticks at the start, next to rest any slip rests at once: friction takes the slopes of
/// the slip away, by the impulse J with W J = −u and the mobility W of the tip along the plane.
void rest_at_start(const model::MicrobodySystem& system, const std::vector<ShiftedBodies>& shifted,
                   ConstState x0, SlopeMatrix& start);

}  // namespace mariotte::impact
