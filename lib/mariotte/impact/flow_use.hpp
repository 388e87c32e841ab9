// Which flows a run used and what it did without: the same for every model.
#pragma once
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"

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

}  // namespace mariotte::impact
