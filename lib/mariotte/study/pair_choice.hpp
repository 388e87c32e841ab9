// The two bodies of a scene that has no others.
#pragma once
#include <string>

#include "mariotte/impact/pair/pair_restitution.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::study {

/// The contact of a [chain] of two balls, or of a ball and a wall. Throws SceneError, with `file` and "only
/// two bodies of a [chain] can be" before `what`, if the scene is another.
impact::Pair pair_of(const scene::Scene& scene, const std::string& file, const char* what);

}  // namespace mariotte::study
