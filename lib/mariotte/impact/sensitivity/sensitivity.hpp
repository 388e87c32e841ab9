// Exact slopes of the outcome of an impact by its parameters, through every event.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/sensitivity/parameter.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// Slopes of one outcome by every parameter [unit of the outcome / unit of the parameter]; empty where there
/// is none, and `reason` then says why.
struct OutcomeSlopes {
  std::string name;            ///< as "velocity", "impulse", "icr" or "time"
  std::optional<Index> index;  ///< of an array
  double value = 0;
  std::vector<std::optional<double>> slope;
};

/// What is to be said of the slopes of a run.
struct SlopeNote {
  std::string what;
};

/// The outcome of a run and how it moves.
struct Sensitivity {
  hybrid::Ending ending = hybrid::Ending::failed;
  std::string message;
  std::vector<std::string> parameter;
  std::vector<double> parameter_value;
  std::vector<OutcomeSlopes> outcome;
  std::vector<std::string> notes;  ///< where slopes are one-sided, large or missing
};

/// The numbers of a chain: masses, velocities, gaps, numbers of its laws, and gravity if it acts.
std::vector<Parameter<model::Chain>> parameters(const model::Chain& chain);

/// Slopes of final velocities, impulses, their ratios and the time of the ending. Throws InvalidParameter as
/// `simulate`.
Sensitivity sensitivity(const model::Chain& chain, const std::vector<Parameter<model::Chain>>& by,
                        const hybrid::Options& options = {});

}  // namespace mariotte::impact
