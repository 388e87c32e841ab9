// Values that the [[sweep]] tables of a scene give to parameters, and the axes of the grid.
#pragma once
#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/design.hpp"
#include "mariotte/study/sweep/design_trials.hpp"

namespace mariotte::study {

/// Fills in the values of all parameters, and the axes. Throws SceneError.
void read_axes(scene::Document& document, const Meaning& meaning, Design& design);

}  // namespace mariotte::study
