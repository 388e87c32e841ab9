// Bodies that fly as a whole, seen by somebody who flies along.
#pragma once
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/moving_frame.hpp"

namespace mariotte::impact {

/// The frame of the first body, where neither planes nor gravity tell one frame from another.
MovingFrame moving_frame(const model::Bodies& bodies);

/// Bodies as seen in the frame.
model::Bodies within(const MovingFrame& frame, model::Bodies bodies);

/// What is seen from outside again, but for residuals and the work within; `bodies` are those of the outside.
void leave(const MovingFrame& frame, const model::Bodies& bodies, BodiesImpact& impact);

}  // namespace mariotte::impact
