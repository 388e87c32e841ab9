// The sentence that a page leads with.
#pragma once
#include <string>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// What happened in a run, or what a sweep found, in one or two sentences; empty for other results.
std::string lead(const Json& result);

}  // namespace mariotte::report
