// What a sweep back through a piece does at one contact, with the widest vectors that this machine has.
#pragma once
#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/impact/sensitivity/gauss.hpp"

namespace mariotte::impact {

/// ∫ from each point to the end, by Lagrange polynomials.
struct UntilEnd {
  double weight[stages][stages];  ///< by the point that is taken

  UntilEnd();
};

/// A contact between two balls, at all points of a piece.
struct ContactTurn {
  const UntilEnd& until_end;
  double left_mobility, right_mobility;   ///< inverse masses
  const double *left, *right;             ///< λ_v of the balls
  const double *by_depth, *by_rate;       ///< slopes of the force, times the pace
  const double* pace;                     ///< dt/du
  double held;                            ///< λ_g at the end, but for what drifts by it already
  double *mu, *gap_rate, *velocity_rate;  ///< become λ · push, and how λ_g and λ_v move
  double *next_left, *next_right;         ///< λ_v, to which that is added
};

using TurnContact = void (*)(const ContactTurn&);
MARIOTTE_PER_INSTRUCTION_SET(TurnContact, choose_turn, (), ())

}  // namespace mariotte::impact
