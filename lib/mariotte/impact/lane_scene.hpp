// Which scenes may be followed side by side, one in each lane of a register.
#pragma once
#include <cmath>

#include "mariotte/hybrid/options.hpp"

namespace mariotte::impact {

/// No power of such a number that occurs leaves the doubles.
inline bool is_moderate(double size) {
  constexpr double moderate = 1e40;
  return size >= 1 / moderate && size <= moderate;
}

/// No flow and no limit is asked for that a small impact could meet.
inline bool asks_for_accuracy_alone(const hybrid::Options& options) {
  constexpr Index events = 100;  // of a small impact, at most
  return std::isinf(options.max_time) && options.max_events > events && !options.flow &&
         options.islands != hybrid::Islands::always;
}

}  // namespace mariotte::impact
