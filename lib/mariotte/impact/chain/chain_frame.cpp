#include "mariotte/impact/chain/chain_frame.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {
namespace {

bool is_alone(const model::Chain& chain) {
  return chain.gravity == 0 && chain.drive.empty() &&
         std::none_of(chain.mass.begin(), chain.mass.end(), [](double m) { return std::isinf(m); });
}

/// The share of an estimated error, which is relative to the largest speed.
void leave(const MovingFrame& frame, std::optional<double>& estimate) {
  if (estimate) *estimate *= frame.share;
}

}  // namespace

MovingFrame moving_frame(const model::Chain& chain) {
  return is_alone(chain) ? frame_of_first(chain.velocity, 1) : MovingFrame{};
}

void leave(const MovingFrame& frame, BriefImpact& impact) {
  leave(frame, impact.velocity);
  leave(frame, impact.estimated_accuracy);
}

void leave(const MovingFrame& frame, const model::Chain& chain, ChainImpact& impact) {
  leave(
      frame, chain.velocity,
      [&](const std::vector<double>& velocity) { return kinetic_energy(chain, velocity); }, impact);
  for (const double mass : chain.mass) {
    impact.momentum.initial += mass * frame.at(0);
    impact.momentum.final += mass * frame.at(0);
  }
  leave(frame, impact.estimated_accuracy);
}

}  // namespace mariotte::impact
