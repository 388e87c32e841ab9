// Networks that fly as a whole, seen by somebody who flies along.
#pragma once
#include "mariotte/impact/moving_frame.hpp"
#include "mariotte/impact/network/network_impact.hpp"

namespace mariotte::impact {

/// The frame of the first ball, or of degree of freedom 1 if there are no balls, where gaps do not depend on
/// a common velocity and no wall or drive tells one frame from another.
MovingFrame moving_frame(const model::Network& network);

/// What is seen from outside again, but for the momentum residual; `network` is that of the outside.
void leave(const MovingFrame& frame, const model::Network& network, NetworkImpact& impact);

}  // namespace mariotte::impact
