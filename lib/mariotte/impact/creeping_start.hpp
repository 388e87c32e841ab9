// Balls that come together so slowly at the start that what an accuracy leaves out of them matters later.
#pragma once
#include "mariotte/model/chain/dimensionless_chain.hpp"

namespace mariotte::impact {

/// An approach below a hundred times the accuracy, relative to the reference speed. What is wrong with it
/// moves a ball for as long as others fly, and so the instants at which contacts close that push harder.
inline bool is_creeping(double approach, double accuracy, double speed) {
  constexpr double slow = 100;
  return approach > 0 && approach <= slow * accuracy * speed;
}

/// Of some neighbours.
inline bool creeps(const model::Chain& chain, double accuracy) {
  const double speed = model::reference_speed(chain);
  for (std::size_t j = 0; j + 1 < chain.velocity.size(); ++j)
    if (is_creeping(chain.velocity[j] - chain.velocity[j + 1], accuracy, speed)) return true;
  return false;
}

}  // namespace mariotte::impact
