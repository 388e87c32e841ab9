// From the counts of a run to what its result tells of the flows, and in its words.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mariotte/hybrid/trajectory.hpp"
#include "mariotte/impact/flow_use.hpp"

namespace mariotte::impact {

/// Flows that followed at least one phase; counts by flow::Kind.
std::vector<FlowUse> flow_uses(const std::array<hybrid::FlowCount, flow::kinds.size()>& counts);

/// "1 phase", "12 phases".
std::string phases(Index count);

}  // namespace mariotte::impact
