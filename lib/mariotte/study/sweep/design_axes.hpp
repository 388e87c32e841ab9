// Values that the [[sweep]] tables of a scene give to parameters, and the axes of the grid.
#pragma once
#include <string>
#include <string_view>

#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/design.hpp"
#include "mariotte/study/sweep/design_trials.hpp"

namespace mariotte::study {

/// Fills in the values of all parameters, and the axes. Throws SceneError.
void read_axes(scene::Document& document, const Meaning& meaning, Design& design);

/// SI unit of a key of a scene: a frequency counts periods, of other rates none is known; energy per area is
/// no stiffness, and an angle no plain number.
std::string unit_of_key(std::string_view key, const Dimension& dimension);

}  // namespace mariotte::study
