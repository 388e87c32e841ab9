// What bodies with friction cost by series and by CVODE.
#pragma once
#include <string>

#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Lines of scenes: run time and error of `auto` and of CVODE's Adams at the same accuracy asked for.
std::string friction_cost(const measuring::Patience& patience);

}  // namespace mariotte::work_precision
