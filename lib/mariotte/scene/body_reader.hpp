// `[body]`, `[surface]` and `[incidence]`: a microbody that strikes a plane, resolved to SI.
#pragma once
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// Throws SceneError. `root` has [body]; `run` is what [run] says, if anything.
model::Microbody read_microbody(Source& source, const Field& root, const std::optional<Field>& run);

}  // namespace mariotte::scene
