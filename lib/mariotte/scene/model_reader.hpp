// `[chain]`, `[network]`, `[body]` or `[bodies]` of a scene, or none where `[law]` stands alone.
#pragma once
#include "mariotte/scene/field.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::scene {

inline constexpr const char* no_model = "the scene has no [chain], [network], [body] or [bodies]";

/// Throws SceneError if the scene is of two models, or of one that the purpose has no use for.
void expect_one_model(const Source& source, const Field& root, Purpose purpose);

/// A model, and what is known of its bodies, as in `Scene`.
struct ResolvedModel {
  Model model;
  std::vector<double> radius = {};
  std::vector<impact::Touching> touching = {};
  std::vector<model::Ball> ball = {};
  double reach = 0;
};

/// What is to be simulated needs a model; for the law its own masses are enough. Throws SceneError; warns of
/// what looks like a slip.
ResolvedModel read_model(Source& source, const Field& root, const std::optional<Law>& law, Purpose purpose);

}  // namespace mariotte::scene
