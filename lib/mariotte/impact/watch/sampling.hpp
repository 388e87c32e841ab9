// Looking at chosen balls and contacts of a run at chosen times, while it runs.
#pragma once
#include <functional>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"

namespace mariotte::impact {

/// A run at one instant, in the chain's units.
struct Sample {
  double time = 0;                    ///< [s]
  double natural_time = 0;            ///< shortest of the chain's contacts [s]: what makes a fine interval
  double crossing_time = 0;           ///< sum of those of all contacts [s]: about what a wave takes
  std::vector<double> velocity = {};  ///< of the chosen balls [m/s]
  std::vector<double> gap = {};       ///< of the chosen contacts [m]
  std::vector<double> force = {};     ///< of the chosen contacts [N]
};

/// What to look at, counted from 0, and who is told.
struct Sampling {
  std::vector<Index> balls = {}, contacts = {};
  /// Takes a sample and says how long until the next, > 0 [s]. The first is of the start, the last of the
  /// ending.
  std::function<double(const Sample&)> take = {};
};

/// How far a run is.
struct Progress {
  double time = 0;  ///< [s]
  Index events = 0;
};

/// Who looks on.
struct Watching {
  bool trace = false;  ///< as of `simulate`
  std::vector<Sampling> samplings = {};
  /// Told after every event of a chain in islands; may be empty.
  std::function<void(const Progress&)> progress = {};
};

/// As `simulate`; a chain that is sampled is divided into islands, whatever its length. Nothing is kept of
/// the samples. Throws InvalidParameter for balls or contacts that do not exist as well.
ChainImpact simulate(const model::Chain& chain, const hybrid::Options& options, const Watching& watching);

}  // namespace mariotte::impact
