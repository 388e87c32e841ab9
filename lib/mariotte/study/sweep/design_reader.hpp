// `[[sweep]]` tables to a design.
#pragma once
#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::study {

/// Reads the design of a sweep and makes every key it varies a value of the document's tree. Units are
/// checked against what the scene reader takes each key for; values that no scene may have are rejected at
/// their place. Throws SceneError.
Design read_design(scene::Document& document);

/// Puts values at the keys of a design: a node per parameter, of which variables put theirs nowhere, then per
/// key that is derived.
void assign(scene::Document& document, const Design& design, const std::vector<scene::Node>& values);

/// Of a point: the value of every parameter, and of what is derived.
std::vector<scene::Node> values(const Design& design, Index point);

}  // namespace mariotte::study
