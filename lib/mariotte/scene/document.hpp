// A scene file that is parsed but not resolved: its values can be replaced, and it can be resolved as often
// as one likes.
#pragma once
#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/source.hpp"

namespace mariotte::scene {

struct Document {
  Source source;
  Node tree;           ///< the overrides applied
  std::string sha256;  ///< its fingerprint
};

/// Parse a file, or text of which `name` is the file in messages. Throw FileError or SceneError.
Document open(const std::string& path, const Overrides& overrides = {});
Document parse_document(const std::string& text, const std::string& name, const Overrides& overrides = {});

/// The scene that a document describes. With `watch`, notes which of its nodes were read as numbers, even if
/// the scene is rejected. Throws SceneError.
Scene resolve(const Document& document, Purpose purpose = Purpose::simulation, ReadingLog* watch = nullptr);

}  // namespace mariotte::scene
