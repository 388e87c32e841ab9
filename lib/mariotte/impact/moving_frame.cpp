#include "mariotte/impact/moving_frame.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {

MovingFrame frame_of_first(std::span<const double> velocities, std::size_t dimension) {
  constexpr double slow = 0.1;
  MovingFrame frame{.dimension = dimension};
  std::copy_n(velocities.begin(), dimension, frame.velocity.begin());
  double largest = 0, within = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    largest = std::max(largest, std::abs(velocities[i]));
    within = std::max(within, std::abs(velocities[i] - frame.at(i)));
  }
  if (within == 0 || !(within < slow * largest)) return {};
  frame.share = within / largest;
  return frame;
}

void enter(const MovingFrame& frame, std::vector<double>& velocities) {
  for (std::size_t i = 0; i < velocities.size(); ++i) velocities[i] -= frame.at(i);
}

void leave(const MovingFrame& frame, std::vector<double>& velocities) {
  for (std::size_t i = 0; i < velocities.size(); ++i) velocities[i] += frame.at(i);
}

RunObserver from_outside(const MovingFrame& frame, RunObserver observers) {
  for (auto& sampling : observers.samplings)
    sampling.take = [take = sampling.take, chosen = sampling.velocities, frame](Sample sample) {
      for (std::size_t i = 0; i < chosen.size(); ++i)
        sample.velocity[i] += frame.at(static_cast<std::size_t>(chosen[i]));
      return take(sample);
    };
  return observers;
}

}  // namespace mariotte::impact
