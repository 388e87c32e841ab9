// What a caller may ask of a run.
#pragma once
#include <optional>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/kind.hpp"

namespace mariotte::hybrid {

/// Whether a long system is divided into parts with clocks of their own.
enum class Islands { automatic, never, always };

/// Accuracy, limits, and how to get there.
struct Options {
  double accuracy = 1e-10;  ///< wanted error of the final velocities relative to the largest incident speed
  double max_time = infinity;           ///< stop at this time [s]
  Index max_events = 1000000;           ///< stop after so many changes of the set of contacts
  std::optional<flow::Kind> flow = {};  ///< of every contact phase that it admits; if empty, the cheapest
  Islands islands = Islands::automatic;
  bool flies_on = false;  ///< bodies that have separated for good fly on to max_time
};

/// Throws InvalidParameter unless accuracy, limits and flow make sense.
void validate(const Options& options);

}  // namespace mariotte::hybrid
