// What outside drives do to the velocities of a phase as functions of time.
#pragma once
#include <vector>

#include "mariotte/core/contact_direction.hpp"
#include "mariotte/core/signal_piece.hpp"

namespace mariotte::flow {

/// A motion that is prescribed, or a force, while one piece of its signal holds. Dofs are places in the
/// state.
struct Drive {
  ContactDirection direction;  ///< of what it is
  ContactDirection response;   ///< its share in the rates of velocities
  bool is_force;
  SignalPiece change;  ///< acceleration or force, at times of the clock
  double end;          ///< time of the clock at which the next piece begins; or infinite
  Index guard;         ///< of that
  Index work;          ///< place of what the drive has done
};

struct Drives {
  Index clock;  ///< place of the time in the state
  std::vector<Drive> drive;
};

}  // namespace mariotte::flow
