// What is being read: its name for messages, and what was noticed on the way.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/node.hpp"

namespace mariotte::scene {

struct Source {
  std::string name;                   ///< the file, as the user wrote it
  std::vector<std::string> set_keys;  ///< the KEY of every override
  std::vector<std::string> warnings = {};
};

/// "file:line:column", or "--set KEY" for what an override wrote.
std::string where(const Source& source, const Place& place);

/// Throws SceneError "where: message", shortened and on one line whatever the scene contains.
[[noreturn]] void reject(const Source& source, const Place& place, const std::string& message);

/// Adds "where: message" to the warnings; after the first twenty only once more, to say so.
void warn(Source& source, const Place& place, const std::string& message);

}  // namespace mariotte::scene
