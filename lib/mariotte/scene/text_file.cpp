#include "mariotte/scene/text_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "mariotte/scene/scene.hpp"

namespace mariotte::scene {

std::string read_text(const std::string& path, std::size_t longest) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!exists(status)) throw FileError(path + ": no such file", path, ENOENT);
  if (is_directory(status)) throw FileError(path + ": is a folder", path, EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::string part(1 << 20, '\0');
  do {
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > longest)
      throw FileError(path + ": is longer than " + std::to_string(longest >> 20) + " MiB", path, EFBIG);
  } while (file);
  // The end of the file sets failbit, so only what was opened and what broke are asked.
  if (!file.is_open() || file.bad()) throw FileError(path + ": cannot be read", path, errno);
  return text;
}

}  // namespace mariotte::scene
