// Slopes of what flies as a whole: seen by somebody who flies along, as runs are. The frame stays when a
// number moves, so slopes are those of outside.
#pragma once
#include "mariotte/impact/moving_frame.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::impact {

/// Velocities as seen from outside again.
inline void leave(const MovingFrame& frame, Sensitivity& found) {
  if (!frame) return;
  for (auto& outcome : found.outcome)
    if (outcome.name.ends_with("velocity"))
      *outcome.value += frame.at(static_cast<std::size_t>(*outcome.index));
}

}  // namespace mariotte::impact
