#include "command_line/named_files.hpp"

#include <fmt/format.h>

#include <map>

#include "command_line/exit_code.hpp"

namespace mariotte::command {
namespace {

/// Where it is, however its folder is written; a link that stands for a file is replaced, not followed.
std::filesystem::path place_of(const std::filesystem::path& file) {
  std::error_code ignored;
  const auto folder = std::filesystem::absolute(file, ignored).parent_path();
  return std::filesystem::weakly_canonical(folder, ignored) / file.filename();
}

}  // namespace

std::vector<std::filesystem::path> within(const std::filesystem::path& folder,
                                          const std::vector<std::string>& names) {
  std::vector<std::filesystem::path> files;
  if (folder.empty()) return files;
  for (const auto& name : names) files.push_back(folder / name);
  return files;
}

void expect_distinct(const std::vector<NamedFiles>& all) {
  std::map<std::filesystem::path, std::string> known;
  for (const auto& [word, files] : all)
    for (const auto& file : files) {
      const auto [other, is_new] = known.try_emplace(place_of(file), word);
      if (!is_new)
        throw UsageError(fmt::format("{} and {} are one file, {}", other->second, word, file.string()));
    }
}

}  // namespace mariotte::command
