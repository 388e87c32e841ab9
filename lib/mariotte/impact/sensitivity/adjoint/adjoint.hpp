// The slopes of one outcome of a row by all its numbers, by one sweep back through its run.
#pragma once
#include <span>

#include "mariotte/impact/sensitivity/adjoint/adjoint_sweep.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::impact {

/// Slopes of Σ w_i v_i⁺, in the units of the chain, and what they took.
struct Adjoint {
  hybrid::Ending ending = hybrid::Ending::failed;
  std::string message;  ///< why, for endings other than separated
  double value = 0;     ///< of the sum
  RowSlopes slopes;
  Index pieces = 0;       ///< of the run
  Index runs = 0;         ///< that it took to have all of them, most of them of a part of the way
  std::size_t bytes = 0;  ///< that were held at once, states on the way included
};

/// What `adjoint` does not know of a chain: gravity, drives, laws that are no power laws; null if nothing.
const char* why_no_adjoint(const model::Chain& chain);

/// One weight per ball. What it costs does not depend on the number of parameters. Slopes by a damping that
/// is 0 and an exponent that is 1 have one side. The motion is kept as far as it has room in `most_bytes`,
/// a quarter of which is for states on the way; from these the row runs again for what is missing. Throws
/// InvalidParameter as `simulate`, for what is not known, and where other flows than series follow the row.
Adjoint adjoint(
    const model::Chain& chain, std::span<const double> weights, const hybrid::Options& options = {},
    const SlopeWatch& watch = [] {}, std::size_t most_bytes = std::size_t{1} << 30);

/// The slope by anything that the numbers of the chain depend on.
double slope_by(const RowSlopes& slopes, const Parameter<model::Chain>& parameter);

/// The one note there is: which slopes are missing, and why.
void note_waiting(Sensitivity& swept);

/// The slopes of a velocity by all parameters of the chain, in their order.
Sensitivity as_sensitivity(const model::Chain& chain, const Adjoint& adjoint, const std::string& name,
                           std::optional<Index> index);

}  // namespace mariotte::impact
