// TOML text to a tree of values.
#pragma once
#include <string_view>

#include "mariotte/scene/source.hpp"

namespace mariotte::scene {

/// The tree of a TOML document, its root a table. Throws SceneError with line and column.
Node parse_toml(const Source& source, std::string_view text);

}  // namespace mariotte::scene
