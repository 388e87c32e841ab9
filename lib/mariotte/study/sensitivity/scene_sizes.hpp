// How large the numbers of a scene are.
#pragma once
#include "mariotte/core/dimension.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::study {

/// A number of this dimension as the scene has them, from its smallest mass and radius and its largest speed:
/// what takes the place of a number that is zero, where something is a share of it.
double typical(const scene::Scene& scene, const Dimension& dimension);

}  // namespace mariotte::study
