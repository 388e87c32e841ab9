// Which lanes a lane feels.
#pragma once
#include "mariotte/flow/taylor/taylor_lanes.hpp"

namespace mariotte::flow::taylor {

/// Run use(other, weight) for the forces in δ̈ = Σ weight f_other of a lane, its own among them.
template <class Use>
void for_each_felt(const Lanes& l, int lane, Use&& use) {
  if (l.linked) {
    const auto& [first, other, weight] = l.links;
    for (int i = first[lane]; i < first[lane + 1]; ++i) use(other[i], weight[i]);
    return;
  }
  if (lane > 0) use(lane - 1, l.left[lane]);
  use(lane, -(l.left[lane] + l.right[lane]));
  if (lane + 1 < l.count) use(lane + 1, l.right[lane]);
}

}  // namespace mariotte::flow::taylor
