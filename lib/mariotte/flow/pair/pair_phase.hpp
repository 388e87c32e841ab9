// One closed contact between two bodies of a row.
#pragma once
#include <optional>

#include "mariotte/flow/pair/pair_motion.hpp"
#include "mariotte/flow/serial_phase.hpp"

namespace mariotte::flow {

/// A phase in which two bodies push each other through one contact and everything else flies freely at
/// constant velocity: where its quantities stand in the state. −1 for what does not exist.
struct PairPhase {
  PairLaw law;
  double left_share;              ///< m*/m of the left body: what it takes of a change of δ̇
  double right_share;             ///< m*/m of the right body
  Index left, right;              ///< velocities; δ̇ = x[left] − x[right]
  Index gap;                      ///< δ = −x[gap]
  Index work;                     ///< ∫ f δ̇ dt
  Index impulse;                  ///< ∫ f dt
  Index guard;                    ///< that fires when the contact lets go
  Index branch_guard;             ///< where it yields, before that of its turns
  double turn_speed;              ///< at which it has turned
  double yield_speed;             ///< below which energy does not tell a yield from the turn
  double origin;                  ///< δ less the indentation of the closed form
  Index left_gap, right_gap;      ///< gaps of the two bodies to their other neighbours
  Index left_guard, right_guard;  ///< guards of these gaps
};

/// The phase as one pair, if it is one whose contact has a closed form.
std::optional<PairPhase> find_pair(const SerialPhase& phase);

}  // namespace mariotte::flow
