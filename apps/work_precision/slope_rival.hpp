// Slopes of three balls as a user of CVODES finds them: its forward sensitivities, staggered, by Adams, of
// forces that are cut off at zero, to a fixed time past the last separation.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/model/chain/chain.hpp"
#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Slopes of the final velocities by all parameters of the chain: one row per velocity.
using VelocitySlopes = std::vector<std::vector<double>>;

/// What it took.
struct RivalSlopes {
  double seconds;  ///< CPU time
  double error;    ///< of the slopes, relative to the largest
};

/// A chain of power laws, with numbers of order one, to the loosest tolerance at which slopes are as right as
/// `accuracy`; nothing if none is. `slopes` are the right ones, `end` is when the chain has separated.
std::optional<RivalSlopes> slopes_by_cvodes(const model::Chain& chain, double end,
                                            const VelocitySlopes& slopes, double accuracy,
                                            const measuring::Patience& patience);

}  // namespace mariotte::work_precision
