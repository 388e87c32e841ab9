// What slopes cost beside a run.
#pragma once
#include <string>

#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Lines of three balls: the time of a run, and that of all slopes and of one as multiples of it. Lines of rows:
/// the same of all slopes of one velocity, swept back, and the memory that takes.
std::string slope_cost(const measuring::Patience& patience);

}  // namespace mariotte::work_precision
