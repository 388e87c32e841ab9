// The moving picture of a page.
#pragma once
#include <string>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// A section of a page with the motion as data, and the script that draws it; without motion it says why a
/// run has none, and is empty for other results.
std::string animation(const Json& motion, const Json& result);

}  // namespace mariotte::report
