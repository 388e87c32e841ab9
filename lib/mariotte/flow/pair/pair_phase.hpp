// One closed contact between two bodies of a row.
#pragma once
#include <optional>

#include "mariotte/flow/pair/pair_motion.hpp"
#include "mariotte/flow/serial_phase.hpp"

namespace mariotte::flow {

/// A phase in which two bodies push each other through one contact and everything else flies freely at
/// constant velocity, with places in the state. −1 for what does not exist.
struct PairPhase {
  PairLaw law;
  const PhaseContact* contact;
  double left_share;              ///< m*/m of the left body: what it takes of a change of δ̇
  double right_share;             ///< m*/m of the right body
  Index left, right;              ///< velocities; δ̇ = x[left] − x[right]
  Index guard;                    ///< that fires when the contact lets go
  double yield_speed;             ///< below which energy does not tell a yield from the turn
  Index left_gap, right_gap;      ///< gaps of the two bodies to their other neighbours
  Index left_guard, right_guard;  ///< guards of these gaps
};

/// The phase, which must outlive it, as one pair, if it is one whose contact has a closed form.
std::optional<PairPhase> find_pair(const SerialPhase& phase);

}  // namespace mariotte::flow
