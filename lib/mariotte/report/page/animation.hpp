// The moving picture of a page.
#pragma once
#include <string>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// A section of a page with the motion as data, and the script that draws it; empty without motion.
std::string animation(const Json& motion);

}  // namespace mariotte::report
