// A set of guards that cross at one instant is one event.
#pragma once
#include <algorithm>
#include <vector>

#include "mariotte/flow/problem.hpp"

namespace mariotte::flow {

/// Finds the guards that fire together with the one that ended a phase.
class Simultaneous {
 public:
  /// Append every guard not yet in `fired` that the tangent of the trajectory carries past zero, the way that
  /// fires it, within `window` of time from x. One that rounding has put past zero already is among them, so
  /// that no crossing is lost.
  void collect(const Problem& problem, ConstState x, double window, std::vector<Index>& fired);

 private:
  std::vector<double> slope_, ahead_, now_, soon_;
};

/// The accuracy, or what it takes to tell the sign of the least load that matters: rates must be known to
/// that load over the damping group. Not below `finest`.
inline double resolving_accuracy(const Problem& problem, double accuracy, double finest) {
  const double ratio = problem.damping_group();
  if (!(ratio > 1) || !(ratio < infinity)) return accuracy;
  return std::min(accuracy, std::max(finest, problem.least_load(accuracy) / ratio));
}

/// Events closer than this fraction of accuracy × time scale cannot be told apart.
inline double simultaneity_window(const Problem& problem, double accuracy) {
  return 0.1 * accuracy * problem.time_scale();
}

}  // namespace mariotte::flow
