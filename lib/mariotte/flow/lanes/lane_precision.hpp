// What steps of small impacts, which are followed side by side, have to keep.
#pragma once
#include <algorithm>
#include <span>

#include "mariotte/flow/taylor/taylor_stepper.hpp"

namespace mariotte::flow {

/// The order of the series for accuracies above a bound.
struct LaneOrder {
  double above;
  int order;
};

/// By what is quickest. After an onset coefficients come in fives, of roots at k = 1, 6, …: the last two must
/// have one of these.
inline constexpr LaneOrder triplet_orders[] = {{1e-5, 10}, {1e-7, 12}, {1e-9, 15}, {1e-13, 17}, {0, 20}},
                           sphere_orders[] = {{1e-5, 10}, {1e-9, 12}, {1e-11, 15}, {1e-13, 17}, {0, 20}},
                           short_row_orders[] = {{1e-5, 11}, {1e-7, 13}, {1e-9, 16}, {1e-13, 18}, {0, 20}};

/// Shares of the accuracy that one step may spend. Errors of a small impact hardly add up; those of more
/// balls do, and one impact magnifies that of another.
inline constexpr double share_alone = 0.2, share_in_rows = 0.01;

inline taylor::Precision lane_precision(double accuracy, std::span<const LaneOrder> orders,
                                        double share = share_alone) {
  const auto reached = [&](const LaneOrder& one) { return accuracy > one.above; };
  const auto found = std::find_if(orders.begin(), orders.end(), reached);
  return {.tolerance = std::max(share * accuracy, 0.25 * epsilon), .order = found->order};
}

}  // namespace mariotte::flow
