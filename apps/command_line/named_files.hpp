// The files that one call reads and writes: no two of them may be one.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mariotte::command {

/// Files, and the word of the command line that they come from.
struct NamedFiles {
  std::string word;
  std::vector<std::filesystem::path> files;
};

/// Files of these names in a folder; none if that is not named.
std::vector<std::filesystem::path> within(const std::filesystem::path& folder,
                                          const std::vector<std::string>& names);

/// Throws UsageError if two words name one file.
void expect_distinct(const std::vector<NamedFiles>& all);

}  // namespace mariotte::command
