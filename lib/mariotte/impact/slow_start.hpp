// Bodies that come together so slowly at the start that what an accuracy leaves out of them matters later.
#pragma once
#include "mariotte/core/contact_direction.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/model/network/dimensionless_network.hpp"

namespace mariotte::impact {

/// An approach below a hundred times the accuracy, relative to the reference speed. What is wrong with it
/// moves a body for as long as others fly, and so the instants at which contacts close that push harder.
inline bool is_slow(double approach, double accuracy, double speed) {
  constexpr double slow = 100;
  return approach > 0 && approach <= slow * accuracy * speed;
}

/// Whether some contact starts with such an approach.
inline bool starts_slowly(const model::Chain& chain, double accuracy) {
  const double speed = model::reference_speed(chain);
  for (std::size_t j = 0; j + 1 < chain.velocity.size(); ++j)
    if (is_slow(chain.velocity[j] - chain.velocity[j + 1], accuracy, speed)) return true;
  return false;
}
/// Approaches are sums there: what is left of equal velocities is rounding.
inline bool starts_slowly(const model::Network& network, double accuracy) {
  const double speed = model::reference_speed(network);
  for (const auto& direction : network.direction) {
    double size = 0;
    for (const auto& [dof, g] : direction) size += std::abs(g * network.velocity[dof]);
    const double approach = -gap_rate(direction, network.velocity);
    if (approach > 16 * epsilon * size && is_slow(approach, accuracy, speed)) return true;
  }
  return false;
}
/// Nothing else strikes a single body meanwhile.
inline bool starts_slowly(const model::Microbody&, double) {
  return false;
}
/// A second closing of any contact has these run again.
inline bool starts_slowly(const model::Bodies&, double) {
  return false;
}

}  // namespace mariotte::impact
