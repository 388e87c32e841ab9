// `[bodies]`: rigid bodies with friction, resolved to SI.
#pragma once
#include "mariotte/impact/validity.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

struct ResolvedBodies {
  model::Bodies bodies;
  std::vector<impact::Touching> touching = {};  ///< as in `Scene`, one per contact
};

/// Throws SceneError; warns of what looks like a slip.
ResolvedBodies read_bodies(Source& source, const Field& bodies);

}  // namespace mariotte::scene
