// `--set KEY=VALUE`: change one value of a scene without touching its file.
//
//     KEY   = as key_path.hpp reads it: chain.contact[0].stiffness
//     VALUE = a TOML value, or else text taken as a string: 2, "2 m/s", 2 m/s, [1, 0], { young = 1e9 }
#pragma once
#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/source.hpp"

namespace mariotte::scene {

/// Applies the overrides in order and notes their keys in `source`. Keys and tables that are missing are
/// created; elements of arrays are not. Throws SceneError at "--set KEY" for a path that leads nowhere.
void apply(const Overrides& overrides, Source& source, Node& root);

}  // namespace mariotte::scene
