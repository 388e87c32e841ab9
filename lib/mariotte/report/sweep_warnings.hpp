// Where the points of a sweep are beyond the limits of their model.
#pragma once
#include <string>
#include <vector>

#include "mariotte/study/sweep/sweep_reader.hpp"

namespace mariotte::report {

/// One sentence for each number of the validity that is beyond its limit at some of the points looked at, and
/// the first few warnings of their scenes that are not the sweep's own. These points are one in ten, the ends
/// among them, but no more than 8; where they may have such numbers they are simulated
/// again, as a whole.
std::vector<std::string> warnings(const study::SweepPlan& plan);

/// That velocities of so many points are less exact than was asked.
std::string less_exact(Index points);

}  // namespace mariotte::report
