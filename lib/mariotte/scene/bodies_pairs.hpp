// Which pairs of bodies and planes may touch, and by which laws.
#pragma once
#include <vector>

#include "mariotte/impact/validity.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/scene/balls.hpp"

namespace mariotte::scene {

/// What is known of everything that touches.
struct Touchables {
  std::vector<Ball> body, plane;
};

/// Adds all contacts to the bodies: first those of [[bodies.contact]], in their order, then all others if
/// [bodies] says a law for them. Returns what validity needs of each. Throws SceneError.
std::vector<impact::Touching> read_pairs(Source& source, const Field& bodies, const Touchables& touchables,
                                         model::Bodies& model);

/// Throws SceneError for what laws and their tables have wrong, whatever the bodies are.
void check_pairs(const Source& source, const Field& bodies);

/// Keys of laws, of [bodies] and of [[bodies.contact]].
extern const std::vector<std::string_view> pair_keys;

}  // namespace mariotte::scene
