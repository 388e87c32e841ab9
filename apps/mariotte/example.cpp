#include "example.hpp"

#include <fmt/format.h>

#include "command_line/exit_code.hpp"
#include "example_scenes.hpp"
#include "mariotte/core/nearest.hpp"

namespace mariotte::command {

Words example_names() {
  Words names;
  for (const auto& one : example_scenes) names.emplace_back(one.name);
  return names;
}

Example example(const std::string& name) {
  std::vector<std::string_view> names;
  for (const auto& one : example_scenes) {
    if (name == one.name) return {one.text, one.data};
    names.emplace_back(one.name);
  }
  throw UsageError(fmt::format("no example is called '{}'{} (mariotte demo --list lists them)", name,
                               suggestion_or_few(name, names)),
                   fault::unknown_argument);
}

}  // namespace mariotte::command
