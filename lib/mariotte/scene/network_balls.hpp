// The balls of a network and the contacts that follow from where they are.
#pragma once
#include "mariotte/scene/network_reader.hpp"

namespace mariotte::scene {

/// Throws SceneError.
ResolvedNetwork read_ball_network(Source& source, const Field& network, bool precompressed);

}  // namespace mariotte::scene
