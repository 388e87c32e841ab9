// `[[sweep]]`: checked here, so that a scene is right or wrong whatever is done with it; carried out
// elsewhere.
#pragma once
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// Rejects a list whose tables are not `key` with values, or from and to with count or step.
void expect_sweeps(const Source& source, const Field& list);

}  // namespace mariotte::scene
