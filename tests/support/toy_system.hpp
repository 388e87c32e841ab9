// Hybrid systems of a few lines, for the tests of the event loop.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "mariotte/hybrid/system.hpp"
#include "support/toy_problems.hpp"

namespace mariotte::test {

/// A mode is the number of a phase, the first is 0. What `fired` in it leads to the mode that `next` says.
struct ToySystem {
  using Mode = Index;
  struct Change {
    Index guard;  ///< −1: the phase ended itself
    Mode mode;    ///< from here on
    bool operator==(const Change&) const = default;
  };

  std::vector<std::shared_ptr<flow::Problem>> phases;
  std::function<Mode(Mode, const std::vector<Index>& fired)> next;
  Mode last = -1;  ///< in it the run is over
  hybrid::Ending ends = hybrid::Ending::separated;
  std::vector<Change> starts_with = {}, finishes_with = {};

  void mode_at(ConstState, Mode& mode, std::vector<Change>& changes) const {
    mode = 0;
    changes = starts_with;
  }
  void transition(Mode& mode, const std::vector<Index>& fired, ConstState,
                  std::vector<Change>& changes) const {
    mode = next(mode, fired);
    for (const Index guard : fired) changes.push_back({guard, mode});
    if (fired.empty()) changes.push_back({-1, mode});
  }
  bool is_over(const Mode& mode, ConstState, bool) const { return mode == last; }
  hybrid::Ending ending(const Mode&) const { return ends; }
  void finish(Mode&, std::vector<Change>& changes) const { changes = finishes_with; }
  flow::Problem& problem(Mode mode) { return *phases.at(static_cast<std::size_t>(mode)); }
};

inline ToySystem::Mode following(ToySystem::Mode mode, const std::vector<Index>&) {
  return mode + 1;
}

}  // namespace mariotte::test
