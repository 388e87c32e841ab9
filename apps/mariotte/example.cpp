#include "example.hpp"

#include "command_line/exit_code.hpp"
#include "example_scenes.hpp"
#include "mariotte/core/nearest.hpp"

namespace mariotte::command {

Words example_names() {
  Words names;
  for (const auto& one : example_scenes) names.emplace_back(one.name);
  return names;
}

std::string example(const std::string& name) {
  std::vector<std::string_view> names;
  for (const auto& one : example_scenes) {
    if (name == one.name) return one.text;
    names.emplace_back(one.name);
  }
  throw UsageError(
      "no example is called '" + name + "'" + suggestion(name, names) + " (mariotte demo --list lists them)",
      fault::unknown_argument);
}

}  // namespace mariotte::command
