// What the scene reader makes of the values of a design.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/core/dimension.hpp"
#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::study {

/// What the scene reader took each parameter's value for: the dimension of a number, or something else.
using Meaning = std::vector<std::optional<Dimension>>;

/// By the first and the last values of all parameters. Refuses what cannot be right: a unit that means two
/// things, or a scene that is wrong at both ends. Throws SceneError.
Meaning read_meaning(const scene::Document& document, const Design& design);

/// Rejects a value that is wrong in itself: refused at its own place, whether it stands among the first
/// values of the others or among their last. What is wrong in some company only is for the rows to tell, and
/// so is what double precision cannot carry, which follows from all numbers together. Throws SceneError.
void expect_possible(const scene::Document& document, const Design& design);

}  // namespace mariotte::study
