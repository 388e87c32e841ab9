// Text files as a whole.
#pragma once
#include <cstddef>
#include <string>

namespace mariotte::scene {

/// Bytes of the longest text that is read: more than the scene of a million balls, ball by ball, needs. A
/// device may have no end.
inline constexpr std::size_t longest_text = std::size_t{256} << 20;

/// The content of a file. Throws FileError if it cannot be read or has more bytes than `longest`.
std::string read_text(const std::string& path, std::size_t longest = longest_text);

}  // namespace mariotte::scene
