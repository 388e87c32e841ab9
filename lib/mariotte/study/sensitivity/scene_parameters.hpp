// Numbers of a scene as parameters: radii and materials change a model by the scene's own formulas.
#pragma once
#include <string>
#include <vector>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/scene/document.hpp"

namespace mariotte::study {

/// Numbers of a chain, or of a microbody and its surface, by `keys`: as `sensitivity` takes them.
std::vector<impact::Parameter<model::Chain>> chain_parameters(const scene::Document& document,
                                                              const model::Chain& chain,
                                                              const std::vector<std::string>& keys);
std::vector<impact::Parameter<model::Microbody>> body_parameters(const scene::Document& document,
                                                                 const std::vector<std::string>& keys);

/// The numbers of the model, by the names that `sensitivity` takes.
std::vector<std::string> number_names(const scene::Document& document, const scene::Scene& scene);

/// Slopes of the scene's outcome by `keys`: numbers of the model, as "mass[0]", all of one kind, as "mass" or
/// "contact[1]", or keys of the scene, as "chain.radius". Without keys by all numbers of the model. If all
/// that is asked of a long row of power laws is one velocity, "velocity[7]", slopes of it alone are swept
/// back; if all that is asked of a microbody is "capture_velocity", slopes of that are found. `watch` is
/// called at every step; what it throws reaches the caller. Throws SceneError for a key that is no finite
/// number with scenes on both sides of it, and for a scene with [law] alone.
impact::Sensitivity sensitivity(
    const scene::Document& document, const scene::Scene& scene, const std::vector<std::string>& keys,
    const std::vector<std::string>& outcomes = {}, const impact::SlopeWatch& watch = [] {});

/// The same outcomes without slopes. Throws as `sensitivity`.
impact::Sensitivity outcomes(const scene::Scene& scene);

/// An outcome that is asked for and that a scene does not have; what() says which it has.
struct UnknownOutcome : InvalidParameter {
  using InvalidParameter::InvalidParameter;
};

/// Leaves those of `all` that are asked for, by "velocity[1]", or by "velocity" or "bodies[0]" several at
/// once; all of them if nothing is. Throws UnknownOutcome.
void keep_asked_for(std::vector<impact::OutcomeSlopes>& all, const std::vector<std::string>& of);

}  // namespace mariotte::study
