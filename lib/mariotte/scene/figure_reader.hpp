// Reading `[figure]`.
#pragma once
#include "mariotte/scene/field.hpp"
#include "mariotte/scene/figure.hpp"

namespace mariotte::scene {

/// Throws SceneError.
Figure read_figure(const Source& source, const Field& figure);

}  // namespace mariotte::scene
