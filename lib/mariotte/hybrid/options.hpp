// What a caller may ask of a run.
#pragma once
#include <string>

#include "mariotte/core/scale.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::hybrid {

/// Whether a long system is divided into parts with clocks of their own.
enum class Islands { automatic, never, always };

/// Accuracy, limits, and how to get there.
struct Options {
  double accuracy = 1e-10;  ///< wanted error of the final velocities relative to the largest incident speed
  double max_time = infinity;  ///< stop at this time [s]
  Index max_events = 1000000;  ///< stop after so many changes of the set of contacts
  std::string flow = "auto";   ///< name of the flow of every contact phase; "auto" chooses
  Islands islands = Islands::automatic;
};

/// Throws InvalidParameter unless accuracy and limits make sense.
void validate(const Options& options);

/// Times divided by those of a scale.
inline Options scaled(Options options, const Scale& scale) {
  options.max_time /= scale.time;
  return options;
}

}  // namespace mariotte::hybrid
