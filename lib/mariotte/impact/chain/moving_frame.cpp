#include "mariotte/impact/chain/moving_frame.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/impact/laws/restitution.hpp"

namespace mariotte::impact {
namespace {

bool is_alone(const model::Chain& chain) {
  return chain.gravity == 0 && chain.drive.empty() &&
         std::none_of(chain.mass.begin(), chain.mass.end(), [](double m) { return std::isinf(m); });
}

void add(std::vector<double>& velocities, double velocity) {
  for (double& v : velocities) v += velocity;
}

/// The share of an estimated error, which is relative to the largest speed.
void leave(const MovingFrame& frame, std::optional<double>& estimate) {
  if (estimate) *estimate *= frame.share;
}

}  // namespace

MovingFrame moving_frame(const model::Chain& chain) {
  constexpr double slow = 1e-2;
  const double common = chain.velocity.front();
  double largest = std::abs(common), within = 0;
  for (const double v : chain.velocity) {
    largest = std::max(largest, std::abs(v));
    within = std::max(within, std::abs(v - common));
  }
  if (within == 0 || !(within < slow * largest) || !is_alone(chain)) return {};
  return {.velocity = common, .share = within / largest};
}

void enter(const MovingFrame& frame, const model::Chain& chain, model::Chain& moving) {
  moving = chain;
  add(moving.velocity, -frame.velocity);
}

RunObserver from_outside(const MovingFrame& frame, RunObserver observers) {
  for (auto& sampling : observers.samplings)
    sampling.take = [take = sampling.take, velocity = frame.velocity](Sample sample) {
      add(sample.velocity, velocity);
      return take(sample);
    };
  return observers;
}

void leave(const MovingFrame& frame, BriefImpact& impact) {
  add(impact.velocity, frame.velocity);
  leave(frame, impact.estimated_accuracy);
}

void leave(const MovingFrame& frame, const model::Chain& chain, ChainImpact& impact) {
  auto& energy = impact.energy;
  auto& momentum = impact.momentum;
  auto within = chain.velocity;
  add(within, -frame.velocity);
  add(impact.velocity, frame.velocity);
  const double before = kinetic_energy(chain, chain.velocity);
  energy.initial += before - kinetic_energy(chain, within);
  energy.final = kinetic_energy(chain, impact.velocity);
  energy.ratio_lab = energy_ratio(energy.final, before);
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    momentum.initial += chain.mass[i] * frame.velocity;
    momentum.final += chain.mass[i] * frame.velocity;
  }
  for (auto& row : impact.trace.velocity) add(row, frame.velocity);
  leave(frame, impact.estimated_accuracy);
}

}  // namespace mariotte::impact
