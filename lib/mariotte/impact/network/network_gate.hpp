// What must hold at the end of a run of a network, whichever flow followed it.
#pragma once
#include "mariotte/impact/network/network_impact.hpp"

namespace mariotte::impact {

/// Nothing approaches after separation, energy and momentum balance, no contact has pulled, none has gained
/// energy, and none of those in `open` is deeper than it can be within noise, `noise_depth` of each
/// contact [m]. `largest_rate` is that of the gaps `before` [m/s]. The impact must have its balances; its
/// ending becomes `unsure` if one of these does not hold.
void pass_gate(const Configuration& before, double largest_rate, const std::vector<Index>& open,
               const std::vector<double>& noise_depth, NetworkImpact& impact);

}  // namespace mariotte::impact
