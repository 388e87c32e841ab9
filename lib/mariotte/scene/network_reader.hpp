// `[network]`: a contact network, resolved to SI.
#pragma once
#include "mariotte/impact/validity.hpp"
#include "mariotte/model/network/network.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

struct ResolvedNetwork {
  model::Network network;
  std::vector<double> radius;                   ///< of the balls [m]; empty where the network has none
  std::vector<impact::Touching> touching = {};  ///< this and what follows as in `Scene`
  std::vector<model::Ball> ball = {};
  double reach = 0;
};

/// Of balls, given by [[network.ball]], or of dofs, given by mass, velocity and [[network.contact]].
/// Throws SceneError; warns of what looks like a slip.
ResolvedNetwork read_network(Source& source, const Field& network);

}  // namespace mariotte::scene
