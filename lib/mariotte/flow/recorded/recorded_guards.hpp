// Where a step of a recorded phase ends.
#pragma once
#include "mariotte/flow/recorded/recorded_phase.hpp"
#include "mariotte/flow/series_flow.hpp"

namespace mariotte::flow {

/// The guard that opens the contact of this clock, in whose series it is a root of first order; or −1.
Index landing_guard(const Recording& recording, const series::TapeClock& clock);

/// The first guard that falls in a series up to `reach`. What starts within `rounding` of its change starts
/// at zero. A step ends earlier, without a guard, where the series cannot tell.
SeriesEnd end_of_step(const Recording& recording, const series::TapeSeries& series,
                      const series::TapeClock& clock, double reach, double rounding);

}  // namespace mariotte::flow
