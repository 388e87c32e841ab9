// `[body]`, `[surface]` and `[incidence]`: a microbody that strikes a plane, resolved to SI.
#pragma once
#include "mariotte/impact/validity.hpp"
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

struct ResolvedBody {
  model::Microbody body;
  std::vector<impact::Touching> touching;  ///< one per tip
};

/// Throws SceneError. `root` has [body]; `run` is what [run] says, if anything.
ResolvedBody read_microbody(Source& source, const Field& root, const std::optional<Field>& run);

}  // namespace mariotte::scene
