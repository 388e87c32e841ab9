// What a scene is known by.
#pragma once
#include <string>

#include "mariotte/scene/node.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/source.hpp"

namespace mariotte::scene {

/// Digest of the text, of each override and of each file whose columns the scene reads, as they are now; that
/// of the text alone is that of the file. `tree` has the overrides.
std::string fingerprint(const std::string& text, const Overrides& overrides, const Source& source,
                        const Node& tree);

}  // namespace mariotte::scene
