#include "mariotte/impact/flow_uses.hpp"

namespace mariotte::impact {

std::vector<FlowUse> flow_uses(const std::array<hybrid::FlowCount, flow::kinds.size()>& counts) {
  std::vector<FlowUse> uses;
  for (const auto kind : flow::kinds) {
    const auto& count = counts[static_cast<std::size_t>(kind)];
    if (count.phases > 0)
      uses.push_back({std::string(flow::name(kind)), count.phases, count.steps, count.rhs});
  }
  return uses;
}

std::string phases(Index count) {
  return std::to_string(count) + (count == 1 ? " phase" : " phases");
}

}  // namespace mariotte::impact
