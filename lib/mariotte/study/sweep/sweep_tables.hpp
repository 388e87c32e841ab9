// The [[sweep]] tables of a scene.
#pragma once
#include <vector>

#include "mariotte/scene/document.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::study {

/// All of them. Throws SceneError if there is none, or one is no table of a sweep.
std::vector<scene::Field> tables(const scene::Document& document);

/// Those that vary something, or those that derive a key from others.
std::vector<scene::Field> varied(const scene::Document& document);
std::vector<scene::Field> derived(const scene::Document& document);

/// What says the first or last value of a range; of a distribution, its mean.
scene::Field end_of(const scene::Field& table, bool last);

}  // namespace mariotte::study
