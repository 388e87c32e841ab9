// Looking at a run while it goes on: samples of chosen balls and contacts, progress, and giving it up.
#pragma once
#include <functional>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::impact {

/// A run at one instant, in the units of its model.
struct Sample {
  double time = 0;                    ///< [s]
  double natural_time = 0;            ///< shortest of the contacts [s]: what makes a fine interval
  double crossing_time = 0;           ///< sum of those of all contacts [s]: about what a wave takes
  std::vector<double> velocity = {};  ///< the chosen ones [m/s]
  std::vector<double> gap = {};       ///< of the chosen contacts [m]
  std::vector<double> force = {};     ///< of the chosen contacts, negative where adhesion pulls [N]
};

/// What to look at, counted from 0, and who is told.
struct Sampling {
  std::vector<Index> velocities = {};  ///< of balls, degrees of freedom, or e1 to e3 of a microbody's centre
  std::vector<Index> contacts = {};    ///< or tips of a microbody
  /// Takes a sample and says how long until the next, > 0 [s]. The first is of the start, the last of the
  /// ending.
  std::function<double(const Sample&)> take = {};
  /// Told before a run that stays in the place of a sampled one, at a tighter accuracy, is sampled: its
  /// samples come from the start, and those before do not count. May be empty.
  std::function<void()> restart = {};
};

/// How far a run is.
struct Progress {
  double time = 0;  ///< [s]
  Index events = 0;
};

/// Who looks on while a model is simulated.
struct RunObserver {
  bool trace = false;  ///< keep samples in the result, at most 20 000 rows
  std::vector<Sampling> samplings = {};
  /// Told after every event; may be empty. A run that is repeated at a tighter accuracy tells its way once
  /// more. What it throws ends the run and reaches the caller.
  std::function<void(const Progress&)> progress = {};
  /// Asked after every event and step; may be empty. True ends the run as `interrupted`, with what there is
  /// until then. What it throws reaches the caller.
  std::function<bool()> gives_up = {};
};

/// Whether somebody gives the run up.
inline bool gives_up(const RunObserver& observers) {
  return observers.gives_up && observers.gives_up();
}

/// Tells the time [s] and the number of events, if somebody wants to know.
inline void tell(const RunObserver& observers, double time, Index events) {
  if (observers.progress) observers.progress({.time = time, .events = events});
}

}  // namespace mariotte::impact
