// What a run leaves behind.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/choose.hpp"
#include "mariotte/hybrid/ending.hpp"

namespace mariotte::hybrid {

/// Cost of one flow over a run.
struct FlowCount {
  Index phases = 0;
  Index steps = 0;
  Index rhs = 0;
};

/// Changes of the discrete state at one instant; `Change` is the system's own.
template <class Change>
struct Timed {
  double time;
  Change change;
};

/// All times and states dimensionless, in the scales of the system.
template <class Change>
struct Trajectory {
  Ending ending = Ending::failed;
  std::string message;
  double time = 0;            ///< of the ending
  std::vector<double> state;  ///< at the ending
  /// In order of time; those of one instant are neighbours with equal times.
  std::vector<Timed<Change>> changes;
  Index events = 0;                                   ///< instants at which something changed
  std::array<FlowCount, flow::kinds.size()> flows{};  ///< by flow::Kind
};

/// Empty again; keeps its memory.
template <class Change>
void clear(Trajectory<Change>& run) {
  run.message.clear();
  run.state.clear();
  run.changes.clear();
  run.events = 0;
  run.flows.fill({});
}

/// Changes of one instant are one event; `changes` is emptied.
template <class Change>
void record(Trajectory<Change>& run, double time, std::vector<Change>& changes) {
  if (changes.empty()) return;
  ++run.events;
  for (const auto& change : changes) run.changes.push_back({time, change});
  changes.clear();
}

/// Adds a phase to what a flow has done.
inline void count(FlowCount& use, const flow::Arrival& arrival) {
  ++use.phases;
  use.steps += arrival.steps;
  use.rhs += arrival.rhs;
}

}  // namespace mariotte::hybrid
