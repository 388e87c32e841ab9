#include "mariotte/impact/watch/turning.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {

TurningObserver::TurningObserver(const model::Network& network, const model::ContactPhase& phase,
                                 const Scale& scale)
    : network_(network),
      phase_(phase),
      length_(scale.velocity * scale.time),
      moved_(network.velocity.size(), 0),
      inside_(phase.size()) {}

/// By Simpson's rule: the angle is a measure of an approximation, not a part of the result.
void TurningObserver::observe(const flow::Step& step) {
  const double duration = step.end - step.start;
  step.at(step.start + 0.5 * duration, inside_);
  for (Index i = 0; i < std::ssize(moved_); ++i)
    moved_[i] +=
        duration / 6 *
        (phase_.velocity(step.before, i) + 4 * phase_.velocity(inside_, i) + phase_.velocity(step.after, i));
  for (Index j = 0; j < phase_.contacts(); ++j)
    if (phase_.gap(step.before, j) < 0 || phase_.gap(step.after, j) < 0)
      largest_ = std::max(largest_, length_ * across(j) / network_.distance[j]);
}

double TurningObserver::across(Index contact) const {
  const auto pair = model::balls_of(network_, contact);
  double squared = 0;
  for (Index k = 0; k < network_.dimension; ++k)
    squared += std::pow(
        moved_[pair->right * network_.dimension + k] - moved_[pair->left * network_.dimension + k], 2);
  const double along = gap_rate(network_.direction[contact], moved_);
  return std::sqrt(std::max(0.0, squared - along * along));
}

}  // namespace mariotte::impact
