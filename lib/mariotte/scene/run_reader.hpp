// `[run]`: what a scene asks of the run.
#pragma once
#include <optional>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// Throws SceneError; warns of accuracies that cannot be met or say nothing, and of keys without effect on a
/// chain.
hybrid::Options read_run(Source& source, const Field& run, bool of_body);

}  // namespace mariotte::scene
