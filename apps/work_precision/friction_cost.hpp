// What bodies with friction cost by series, by CVODE and by methods that locate no events.
#pragma once
#include <string>

#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Lines of scenes: run time and error of `auto` and of CVODE's Adams at the same accuracy asked for, and the
/// least time in which rivals come to such an error.
std::string friction_cost(const measuring::Patience& patience);

}  // namespace mariotte::work_precision
