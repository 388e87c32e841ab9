// Balls of a network that fly towards each other from beyond the reach of its contacts.
#pragma once
#include <utility>
#include <vector>

#include "mariotte/model/network/network.hpp"

namespace mariotte::scene {

/// Pairs (i < j, from 0) farther apart than `reach` [m] that would meet by their start velocities before
/// either of them meets another ball.
std::vector<std::pair<Index, Index>> missed_meetings(const std::vector<model::Ball>& balls, double reach);

}  // namespace mariotte::scene
