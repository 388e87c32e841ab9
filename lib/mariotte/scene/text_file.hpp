// Text files as a whole.
#pragma once
#include <string>

namespace mariotte::scene {

/// The content of a file. Throws FileError.
std::string read_text(const std::string& path);

}  // namespace mariotte::scene
