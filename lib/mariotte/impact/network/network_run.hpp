// What whole and brief results of a network have in common.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/impact/promise.hpp"
#include "mariotte/impact/watch/event_list.hpp"
#include "mariotte/model/network/dimensionless_network.hpp"

namespace mariotte::impact {

/// A contact's dimensionless impulse is more than the accuracy leaves open.
inline bool is_felt(const model::DimensionlessNetwork& d, Index j, double impulse, double accuracy) {
  return std::abs(impulse) > accuracy * d.reduced_mass[j] * d.speed;
}

/// Largest difference of the gap rates that two sets of velocities have, relative to `speed` unless that is
/// 0; infinite if one is not a number. As difference(), without what drives prescribe.
inline double rate_difference(const model::Network& network, double speed, ConstState a, ConstState b) {
  double most = 0;
  for (const auto& row : network.direction) {
    double apart = 0;
    for (const auto& [dof, g] : row)
      if (!prescribes(network.drive, dof)) apart += g * (a[dof] - b[dof]);
    apart = std::abs(apart);
    most = apart <= most ? most : apart;
    if (std::isnan(most)) return infinity;
  }
  return speed > 0 ? most / speed : most;
}

}  // namespace mariotte::impact
