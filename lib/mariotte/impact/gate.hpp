// The gate: a run that came to an end is believed only if its balances close.
#pragma once
#include <span>
#include <string>

#include "mariotte/hybrid/ending.hpp"

namespace mariotte::impact {

/// How many times the accuracy a balance may be off: velocities may be wrong by the accuracy, and the errors
/// of many bodies add up. A contact that is missed costs far more.
inline constexpr double balance_allowance = 100;
/// How many times the accuracy, relative to the energy at stake, balances of a body may be off. Each of some
/// ten phases may err by the accuracy in velocity, which counts twice in energy; random bodies reach 20.
inline constexpr double body_slack = 1000;
/// A contact that approaches so slowly that it cannot be told from rest is left alone to a few times the
/// depth it can reach.
inline constexpr double noise_depths = 10;

/// One thing that must hold at the end of a run: |size| ≤ allowed. A size that is not a number never holds.
struct Balance {
  const char* name;  ///< "energy balance", "friction loss below zero", …
  double size;       ///< by how much it does not close, in the unit of `allowed`
  double allowed;    ///< what the accuracy explains
};

/// Whether all of them hold.
bool closes(std::span<const Balance> balances);

/// Turn `ending` into `unsure` if one of the balances does not hold; `message` then names the worst, its size
/// and what to try. Endings `failed` and `unsure` stay as they are. Allocates nothing if all hold.
void pass_gate(std::span<const Balance> balances, hybrid::Ending& ending, std::string& message);

}  // namespace mariotte::impact
