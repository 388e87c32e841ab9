#include "mariotte/impact/network/network_frame.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {
namespace {

/// The gap stays as it is when all balls move alike.
bool keeps_gap(const ContactDirection& direction, std::size_t dimension) {
  std::array<double, 3> rate = {};
  for (const auto& [dof, coefficient] : direction)
    rate[static_cast<std::size_t>(dof) % dimension] += coefficient;
  return rate == std::array<double, 3>{};
}

bool is_alone(const model::Network& network, std::size_t dimension) {
  return network.drive.empty() &&
         std::none_of(network.mass.begin(), network.mass.end(), [](double m) { return std::isinf(m); }) &&
         std::all_of(network.direction.begin(), network.direction.end(),
                     [&](const auto& direction) { return keeps_gap(direction, dimension); });
}

}  // namespace

MovingFrame moving_frame(const model::Network& network) {
  const auto dimension = static_cast<std::size_t>(std::max<Index>(1, network.dimension));
  return is_alone(network, dimension) ? frame_of_first(network.velocity, dimension) : MovingFrame{};
}

void leave(const MovingFrame& frame, const model::Network& network, NetworkImpact& impact) {
  const auto before = configuration_of(network);
  leave(
      frame, network.velocity,
      [&](const std::vector<double>& velocity) { return kinetic_energy(before, velocity); }, impact);
}

}  // namespace mariotte::impact
