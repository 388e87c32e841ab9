#include "mariotte/impact/sensitivity/adjoint/adjoint_sweep.hpp"

#include <algorithm>
#include <utility>

namespace mariotte::impact {
namespace {

RowSlopes slopes_at_end(std::span<const double> weights) {
  const std::vector<double> balls(weights.size()), contacts(weights.size() - 1);
  return {.mass = balls,
          .velocity = {weights.begin(), weights.end()},
          .gap = contacts,
          .stiffness = contacts,
          .damping = contacts,
          .exponent = contacts};
}

}  // namespace

BackSweep::BackSweep(const model::DimensionlessChain& chain, Instant end, std::span<const double> weights)
    : chain_(chain), slopes_(slopes_at_end(weights)), since_(chain.law.size(), end) {}

/// Contacts `first` to `last`, of which some may not exist, back to `time`; they do not push.
void BackSweep::fly(Index first, Index last, Instant time) {
  for (Index j = std::max<Index>(first, 0); j <= std::min(last, std::ssize(since_) - 1); ++j) {
    const double turned = slopes_.gap[j] * (since_[j] - time);
    slopes_.velocity[j] -= turned;
    slopes_.velocity[j + 1] += turned;
    since_[j] = time;
  }
}

void BackSweep::pass(const MotionRecord& motion) {
  PieceSweep pieces(chain_, motion, slopes_);
  auto closing = motion.closing.end();
  for (auto stretch = motion.stretch.rbegin(); stretch != motion.stretch.rend(); ++stretch) {
    fly(stretch->first - 1, stretch->last, stretch->end);
    for (Index n = 0; n < stretch->pieces; ++n) pieces.pass(*stretch);
    std::fill(since_.begin() + stretch->first, since_.begin() + stretch->last, stretch->start);
    for (Index n = 0; n < stretch->closings; ++n) {
      const Index j = *--closing;
      slopes_.gap[j] -=
          pieces.law(j).damping * pieces.turning(j, [&](Index b) { return slopes_.velocity[b]; });
    }
  }
}

RowSlopes BackSweep::take() {
  fly(0, chain_.contacts() - 1, {});
  return std::move(slopes_);
}

}  // namespace mariotte::impact
