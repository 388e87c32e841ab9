// What is being read: its name for messages, and what was noticed on the way.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/core/dimension.hpp"
#include "mariotte/scene/fault.hpp"
#include "mariotte/scene/node.hpp"

namespace mariotte::scene {

/// Nodes somebody wants to know the meaning of.
struct ReadingLog {
  struct Reading {
    const Node* node;
    std::optional<Dimension> dimension = {};  ///< of the number it was read as; empty if it was read as none
    bool is_text = false;                     ///< it was read as words
  };
  std::vector<Reading> readings;
};

struct Source {
  std::string name;                  ///< the file, as the user wrote it
  std::vector<std::string> origins;  ///< where values come from that are not the file's: "--set KEY"
  std::vector<std::string> warnings = {};
  ReadingLog* watch = nullptr;  ///< told of every value that is read; may be null
};

/// "file:line:column", or the origin of what is not the file's, as "--set KEY".
std::string where(const Source& source, const Place& place);

/// The place of whatever comes from there.
Place add_origin(Source& source, std::string origin);

/// Throws SceneError "where: message", shortened and on one line whatever the scene contains; `key` leads to
/// what is wrong.
[[noreturn]] void reject(const Source& source, const Place& place, Fault fault, const std::string& message,
                         const std::string& key = "");

/// Adds "where: message" to the warnings, once; after the first twenty only one more, to say so.
void warn(Source& source, const Place& place, const std::string& message);

}  // namespace mariotte::scene
