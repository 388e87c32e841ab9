// `[chain]`, `[network]` or `[body]` of a scene, or none where `[law]` stands alone.
#pragma once
#include <utility>

#include "mariotte/scene/field.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::scene {

inline constexpr const char* no_model = "the scene has no [chain], [network] or [body]";

/// Throws SceneError if the scene is of two models, or of one that the purpose has no use for.
void expect_one_model(const Source& source, const Field& root, Purpose purpose);

/// The model, and the radii of its balls as in `Scene::radius`. What is to be simulated needs a model; for
/// the law its own masses are enough. Throws SceneError; warns of what looks like a slip.
std::pair<Model, std::vector<double>> read_model(Source& source, const Field& root,
                                                 const std::optional<Law>& law, Purpose purpose);

}  // namespace mariotte::scene
