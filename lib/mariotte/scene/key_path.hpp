// Keys that lead to one value of a scene, as `--set` and `[[sweep]]` write them:
//
//     KEY = name { "." name | "[" index "]" }      indices count from 0
#pragma once
#include <string_view>

#include "mariotte/scene/source.hpp"

namespace mariotte::scene {

/// The node a key leads to. Keys and tables that are missing are created at `place`; elements of arrays are
/// not. Throws SceneError at `place` for a path that leads nowhere.
Node& locate(const Source& source, Node& root, std::string_view key, const Place& place);

/// Makes `place` the place of a node and of all that is in it.
void move_to(const Place& place, Node& node);

}  // namespace mariotte::scene
