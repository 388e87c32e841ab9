// What drives the end of a chain, or velocities of a network.
#pragma once
#include <span>
#include <vector>

#include "mariotte/model/network/network.hpp"
#include "mariotte/scene/balls.hpp"

namespace mariotte::scene {

/// The tables of the drives in [chain] or [network], in order.
std::vector<Field> drive_tables(const Field& whole);

/// The drives of [chain.drive]. What moves as prescribed becomes a wall, with the velocity that it has at the
/// start. Throws SceneError.
std::vector<model::Drive> read_drives(const Source& source, const Field& chain, std::span<Ball> balls);
/// Those of [network.drive], of balls or of other velocities. Throws SceneError.
void read_drives(const Source& source, const Field& network, model::Network& model);

}  // namespace mariotte::scene
