// What bodies alone would do at several speeds, in words.
#pragma once
#include <functional>
#include <string>

#include "mariotte/core/types.hpp"

namespace mariotte::report {

/// One line per contact, or tip, with e at a tenth of this speed, at the speed and at ten times it; a dash
/// for speeds beyond what double precision can carry. A speed of 0 stands for 1 m/s.
std::string restitution_table(const std::string& thing, Index count, double speed,
                              const std::function<double(Index, double speed)>& restitution);

}  // namespace mariotte::report
