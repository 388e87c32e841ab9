#include "mariotte/scene/text_file.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "mariotte/scene/scene.hpp"

namespace mariotte::scene {

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  // An empty file sets failbit on the copy, so only what was opened and what broke are asked.
  if (!file.is_open() || file.bad() || text.bad() || std::filesystem::is_directory(path))
    throw FileError(path + ": cannot be read");
  return std::move(text).str();
}

}  // namespace mariotte::scene
