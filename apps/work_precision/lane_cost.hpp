// What small impacts cost one by one, and side by side in lanes.
#pragma once
#include <string>

#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Lines of sets of Hertz triplets and of microspheres: run time of each by both, measured in turn, and the
/// largest difference of their velocities.
std::string lane_cost(const measuring::Patience& patience);

}  // namespace mariotte::work_precision
