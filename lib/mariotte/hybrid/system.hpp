// What a model must offer to be run by the event loop.
#pragma once
#include <concepts>
#include <vector>

#include "mariotte/flow/problem.hpp"
#include "mariotte/hybrid/ending.hpp"

namespace mariotte::hybrid {

/// A system whose state x is continuous while its mode jumps. A system may add components for what it follows
/// from now on, and give those that a mode alone uses the meaning that the next one reads.
///   mode_at(x, mode, changes)     sets the mode in which the run starts, at 0+
///   transition(mode, fired, x, …) the mode after a set of guards has fired at x, or an Error: there is none
///   is_over(mode, x, impacted)    nothing can happen any more
///   ending(mode)                  the way in which it is over then
///   finish(mode, changes)         the mode to end in, once it is over
///   problem(mode)                 the smooth field of that mode; may be told of accepted steps
/// All but the last depend on their arguments alone; what changed is appended to `changes`.
template <class S>
concept HybridSystem = requires(S& system, const S& fixed, typename S::Mode& mode,
                                const typename S::Mode& from, std::vector<double>& x,
                                std::vector<Index>& fired, bool impacted,
                                std::vector<typename S::Change>& changes) {
  { fixed.mode_at(x, mode, changes) } -> std::same_as<void>;
  { fixed.transition(mode, fired, x, changes) } -> std::same_as<void>;
  { fixed.is_over(from, x, impacted) } -> std::same_as<bool>;
  { fixed.ending(from) } -> std::same_as<Ending>;
  { fixed.finish(mode, changes) } -> std::same_as<void>;
  { system.problem(mode) } -> std::convertible_to<flow::Problem&>;
};

}  // namespace mariotte::hybrid
