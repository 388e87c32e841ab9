// Slopes of one outcome of a row by numbers of its scene, swept back through the run.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/scene/document.hpp"

namespace mariotte::study {

/// Whether slopes of velocities of this scene can be swept back: those of rows of power laws.
bool sweeps_back(const scene::Scene& scene);

/// The ball whose velocity, "velocity[7]", is all that is asked for of a row so long that it is divided into
/// islands. Slopes that run forward would follow all of it.
std::optional<Index> swept_ball(const scene::Scene& scene, const std::vector<std::string>& outcomes);

/// Slopes of the velocity of one ball by `keys`, as `sensitivity` has them.
impact::Sensitivity sensitivity_of_velocity(const scene::Document& document, const scene::Scene& scene,
                                            const std::vector<std::string>& keys, Index ball,
                                            const impact::SlopeWatch& watch);

/// Of the sum of velocities with these weights, one per ball, as the outcome "sum". Throws InvalidParameter
/// where that is not known.
impact::Sensitivity sensitivity_of_sum(const scene::Document& document, const scene::Scene& scene,
                                       const std::vector<std::string>& keys,
                                       const std::vector<double>& weights, const impact::SlopeWatch& watch);

}  // namespace mariotte::study
