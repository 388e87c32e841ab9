// What a pair of each named law costs by the flow that is chosen and by CVODE.
#pragma once
#include <string>

#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Lines of laws: run time of `auto` and of CVODE's Adams at the same accuracy asked for, and the difference
/// of their velocities.
std::string law_cost(const measuring::Patience& patience);

}  // namespace mariotte::work_precision
