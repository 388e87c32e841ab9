// Run time: CPU time of this thread, so that neighbours on the machine count as little as possible.
#pragma once
#include <functional>

#include "mariotte/core/types.hpp"

namespace mariotte::measuring {

/// CPU time this thread has used [s].
double cpu_seconds();

/// CPU time of one call [s].
double timed(const std::function<void()>& action);

/// How long to measure.
struct Patience {
  double batch;  ///< shortest time of one batch of repetitions [s]
  int batches;   ///< the least of so many counts; what takes longer than all of them is not repeated
  double longest = infinity;  ///< what takes longer than this ends a ladder of settings [s]
};

/// CPU time of one call [s]: the least over batches. `first` is the time of a call that has already been
/// made, which warmed things up.
double least_seconds(const std::function<void()>& action, double first, const Patience& patience);

}  // namespace mariotte::measuring
