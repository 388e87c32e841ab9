// Chains that fly as a whole, seen by somebody who flies along.
#pragma once
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/moving_frame.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// The frame of the first ball if nothing outside tells one frame from another: walls, gravity, drives.
MovingFrame moving_frame(const model::Chain& chain);

/// What is seen from outside again; `chain` is that of the outside.
void leave(const MovingFrame& frame, const model::Chain& chain, ChainImpact& impact);
void leave(const MovingFrame& frame, BriefImpact& impact);

}  // namespace mariotte::impact
