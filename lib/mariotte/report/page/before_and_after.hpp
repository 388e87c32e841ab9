// What a page leads with: one sentence, and the bodies before and after.
#pragma once
#include <string>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// What happened in a run, or what a sweep found, in one or two sentences; empty for other results.
std::string lead(const Json& result);

/// Masses, sizes and velocities of the bodies before and after, and the laws of their contacts; empty unless
/// the result has the scene it is of.
std::string before_and_after(const Json& result);

}  // namespace mariotte::report
