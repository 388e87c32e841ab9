// What a scene knows of its bodies, applied to a result.
#pragma once
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::scene {

/// Fills in the validity of a run of the scene's model; one beyond any law ends `invalid`.
void judge(impact::ChainImpact& impact, const Scene& scene);
void judge(impact::NetworkImpact& impact, const Scene& scene);
void judge(impact::MicrobodyImpact& impact, const Scene& scene);
void judge(impact::BodiesImpact& impact, const Scene& scene);

/// Whether there may be a number to fill in.
bool has_validity(const Scene& scene);

}  // namespace mariotte::scene
