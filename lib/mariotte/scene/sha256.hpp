// SHA-256, to name the text a result came from [FIPS 180-4].
#pragma once
#include <string>
#include <string_view>

namespace mariotte::scene {

/// Digest as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace mariotte::scene
