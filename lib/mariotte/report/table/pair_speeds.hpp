// How fast two bodies came together and parted.
#pragma once
#include <optional>

#include "mariotte/impact/chain/chain_impact.hpp"

namespace mariotte::report {

/// Of two balls, or a ball and a wall, at the instants at which their contact closes and opens [m/s].
struct PairSpeeds {
  double approach = 0;
  double separation = 0;
};

/// Empty unless the chain is a pair that has met once, in flight, and parted.
std::optional<PairSpeeds> pair_speeds(const impact::ChainImpact& impact, const model::Chain& chain);

}  // namespace mariotte::report
