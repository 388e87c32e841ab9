// Which flows a run used and what it did without: the same for every model.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mariotte/hybrid/trajectory.hpp"

namespace mariotte::impact {

/// Work done by one flow.
struct FlowUse {
  std::string name;
  Index phases = 0;
  Index steps = 0;
  Index rhs = 0;  ///< evaluations of the right-hand side
};

/// Something that was left out because this scene does not need it.
struct Skipped {
  std::string what;
  std::string why;
};

/// Flows that followed at least one phase; counts by flow::Kind.
std::vector<FlowUse> flow_uses(const std::array<hybrid::FlowCount, flow::kinds.size()>& counts);

}  // namespace mariotte::impact
