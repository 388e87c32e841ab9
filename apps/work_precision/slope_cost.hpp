// What slopes cost beside a run.
#pragma once
#include <string>

#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Lines of three balls: the time of a run and of a brief one by ChainSolver, and as multiples of the first
/// those of all slopes, of one, and of CVODES for all slopes, at an error of them as large as the accuracy.
/// Lines of rows: the same of all slopes of one velocity, swept back, and the memory that takes.
std::string slope_cost(const measuring::Patience& patience);

}  // namespace mariotte::work_precision
