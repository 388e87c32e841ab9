// From a scene to its result.
#pragma once
#include <variant>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::scene {

/// The result of a run: of the model that the scene is of.
using Impact =
    std::variant<impact::ChainImpact, impact::NetworkImpact, impact::MicrobodyImpact, impact::BodiesImpact>;

/// Simulate the scene's model with the options of [run]. Throws SceneError for a scene with [law] alone, and
/// InvalidParameter as the model's own `simulate`.
Impact simulate(const Scene& scene, const impact::RunObserver& observers = {});

}  // namespace mariotte::scene
