#include "mariotte/scene/fingerprint.hpp"

#include <filesystem>

#include "mariotte/core/overload.hpp"
#include "mariotte/scene/sha256.hpp"
#include "mariotte/scene/text_file.hpp"

namespace mariotte::scene {
namespace {

/// Under these keys words name files; those that a [[sweep]] gives in turn are its values.
bool may_name_files(const std::string& key) {
  return key == "table" || key == "values";
}

/// Empty if nobody can read such a file: who needs it says so later.
std::string content_digest(const std::filesystem::path& file) try {
  std::error_code none;
  return std::filesystem::is_regular_file(file, none) ? sha256(read_text(file.string())) : "";
} catch (const FileError&) {
  return "";
}

void add_files(const Node& node, const std::filesystem::path& folder, bool names_files, std::string& all) {
  std::visit(Overload{[&](const std::string& word) {
                        if (names_files && !word.empty()) all += content_digest(folder / word);
                      },
                      [&](const Array& list) {
                        for (const auto& one : list) add_files(one, folder, names_files, all);
                      },
                      [&](const Table& table) {
                        for (const auto& [key, place, value] : table)
                          add_files(value, folder, may_name_files(key), all);
                      },
                      [](const auto&) {}},
             node.value);
}

}  // namespace

std::string fingerprint(const std::string& text, const Overrides& overrides, const Source& source,
                        const Node& tree) {
  std::string all = text, files;
  for (const auto& override : overrides) (all += '\0') += override;  // no scene holds a zero byte
  add_files(tree, std::filesystem::path(source.name).parent_path(), false, files);
  return sha256(files.empty() ? all : (all += '\0') += files);
}

}  // namespace mariotte::scene
