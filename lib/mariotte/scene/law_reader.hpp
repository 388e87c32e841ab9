// `[law]`, resolved to SI.
#pragma once
#include "mariotte/scene/field.hpp"
#include "mariotte/scene/law.hpp"

namespace mariotte::scene {

/// Throws SceneError.
Law read_law(const Source& source, const Field& law);

}  // namespace mariotte::scene
