// The phases of an impact behind a figure over time.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {

/// gnuplot commands that shade the phases until `end` [s], the darker the more contacts are closed, and mark
/// the instants at which contacts close and open. Empty where there are too many events to tell apart.
std::string phase_marks(const std::vector<impact::Event>& events, const Display& time, double end);

}  // namespace mariotte::report
