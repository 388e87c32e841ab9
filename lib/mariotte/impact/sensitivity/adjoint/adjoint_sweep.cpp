#include "mariotte/impact/sensitivity/adjoint/adjoint_sweep.hpp"

#include <algorithm>

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

/// What contacts do that do not push: each stands at a time of its own.
class FreeContacts {
 public:
  FreeContacts(RowSlopes& slopes, Instant end) : slopes_(slopes), since_(slopes.gap.size(), end) {}

  /// Contacts `first` to `last`, of which some may not exist, back to `time`.
  void fly(Index first, Index last, Instant time) {
    for (Index j = std::max<Index>(first, 0); j <= std::min(last, std::ssize(since_) - 1); ++j) {
      const double turned = slopes_.gap[j] * (since_[j] - time);
      slopes_.velocity[j] -= turned;
      slopes_.velocity[j + 1] += turned;
      since_[j] = time;
    }
  }
  /// Those within a stretch, which has been passed.
  void pass(const MotionRecord::Stretch& stretch) {
    std::fill(since_.begin() + stretch.first, since_.begin() + stretch.last, stretch.start);
  }

 private:
  RowSlopes& slopes_;
  std::vector<Instant> since_;
};

}  // namespace

RowSlopes sweep_back(const model::DimensionlessChain& chain, const MotionRecord& motion, Instant end,
                     std::span<const double> weights) {
  auto slopes = slopes_at_end(weights);
  FreeContacts free(slopes, end);
  PieceSweep pieces(chain, motion, slopes);
  auto closing = motion.closing.end();
  for (auto stretch = motion.stretch.rbegin(); stretch != motion.stretch.rend(); ++stretch) {
    free.fly(stretch->first - 1, stretch->last, stretch->end);
    for (Index n = 0; n < stretch->pieces; ++n) pieces.pass(*stretch);
    free.pass(*stretch);
    for (Index n = 0; n < stretch->closings; ++n) {
      const Index j = *--closing;
      slopes.gap[j] -= pieces.law(j).damping * pieces.turning(j, [&](Index b) { return slopes.velocity[b]; });
    }
  }
  free.fly(0, chain.contacts() - 1, {});
  return slopes;
}

}  // namespace mariotte::impact
