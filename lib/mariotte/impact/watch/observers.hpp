// Looking at a run while it goes on: samples of chosen balls and contacts, progress, and giving it up.
#pragma once
#include <functional>
#include <vector>

#include "mariotte/core/types.hpp"

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

/// Who looks on while a model is simulated.
struct RunObserver {
  bool trace = false;                    ///< keep samples in the result, at most a few thousand rows
  std::vector<Sampling> samplings = {};  ///< of chains only
  /// Told after every event; may be empty. What it throws ends the run and reaches the caller, so that a run
  /// can be given up. A run that is repeated at a tighter accuracy tells its way once more.
  std::function<void(const Progress&)> progress = {};
};

/// Tells the time [s] and the number of events, if somebody wants to know.
inline void tell(const RunObserver& observers, double time, Index events) {
  if (observers.progress) observers.progress({.time = time, .events = events});
}

/// Throws InvalidParameter if there are samplings: only chains can be sampled while they are simulated.
void expect_no_samplings(const RunObserver& observers);

}  // namespace mariotte::impact
