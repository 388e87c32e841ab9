// How many steps an impact took.
#pragma once
#include "mariotte/flow/kind.hpp"

namespace mariotte::test {

/// Of all flows.
template <class Impact>
Index steps(const Impact& impact) {
  Index total = 0;
  for (const auto& use : impact.flows) total += use.steps;
  return total;
}

/// Of one.
template <class Impact>
Index steps(const Impact& impact, flow::Kind kind) {
  Index total = 0;
  for (const auto& use : impact.flows)
    if (use.name == flow::name(kind)) total += use.steps;
  return total;
}

}  // namespace mariotte::test
