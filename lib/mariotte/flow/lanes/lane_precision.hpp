// What steps of small impacts, which are followed side by side, have to keep.
#pragma once
#include <algorithm>
#include <utility>

#include "mariotte/flow/taylor/taylor_stepper.hpp"

namespace mariotte::flow {

/// Errors of a small impact hardly add up, so that a step may spend more of the accuracy than in a long row.
/// After an onset coefficients come in fives, of roots at k = 1, 6, …: the last two must have one of these.
inline taylor::Precision lane_precision(double accuracy) {
  taylor::Precision p{.tolerance = std::max(0.2 * accuracy, 0.25 * epsilon), .order = 20};
  for (const auto& [above, order] : {std::pair{1e-5, 10}, {1e-9, 12}, {1e-11, 15}, {1e-13, 17}}) {
    if (!(accuracy > above)) continue;
    p.order = order;
    break;
  }
  return p;
}

}  // namespace mariotte::flow
