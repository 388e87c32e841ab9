// The bodies of a run before and after, on its page.
#pragma once
#include <string>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// Masses, sizes and velocities of the bodies before and after, and the laws of their contacts; empty unless
/// the result has the scene it is of.
std::string before_and_after(const Json& result);

}  // namespace mariotte::report
