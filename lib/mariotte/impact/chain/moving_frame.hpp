// Chains that fly as a whole much faster than their balls move among themselves. Rounding of the common
// velocity would hide what dampers do, and make flows creep; seen by somebody who flies along, it does not.
#pragma once
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// A velocity that all balls share, and what it is of the largest speed.
struct MovingFrame {
  double velocity = 0;  ///< [m/s]; 0 if there is none worth leaving
  double share = 1;     ///< largest speed within the frame, relative to the largest outside
};

/// The frame of the first ball if all others keep within a hundredth of its velocity, and nothing outside
/// tells one frame from another: walls, gravity, drives.
MovingFrame moving_frame(const model::Chain& chain);

/// Sets `moving` to the chain as seen in the frame.
void enter(const MovingFrame& frame, const model::Chain& chain, model::Chain& moving);
/// Observers who are told velocities as seen from outside.
RunObserver from_outside(const MovingFrame& frame, RunObserver observers);
/// Velocities, trace, energy and momentum as seen from outside again; `chain` is that of the outside.
void leave(const MovingFrame& frame, const model::Chain& chain, ChainImpact& impact);
void leave(const MovingFrame& frame, BriefImpact& impact);

}  // namespace mariotte::impact
