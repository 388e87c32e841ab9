// Run time: CPU time of this thread, so that neighbours on the machine count as little as possible.
#pragma once
#include <functional>

namespace mariotte::work_precision {

/// CPU time this thread has used [s].
double cpu_seconds();

/// How long to measure.
struct Patience {
  double batch;    ///< shortest time of one batch of repetitions [s]
  int batches;     ///< the least of so many counts
  double longest;  ///< what takes longer than this is not repeated, and ends its ladder [s]
};

/// CPU time of one call [s]: the least over batches. `first` is the time of a call that has already been
/// made, which warmed things up.
double least_seconds(const std::function<void()>& action, double first, const Patience& patience);

}  // namespace mariotte::work_precision
