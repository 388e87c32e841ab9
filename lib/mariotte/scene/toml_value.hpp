// Values of TOML that are written without quotes and brackets.
#pragma once
#include <string_view>

namespace mariotte::scene {

/// Whether a word is a number, true or false as TOML 1.0 wants it written. The number may still be too large.
/// Dates and times are none: toml++ 3.3 may read on past the end of a wrong one, and a scene has none.
bool is_plain_value(std::string_view word);
/// Whether it would be a number if digits stood on both sides of its point, as ".5" and "5." would.
bool lacks_digit(std::string_view word);

}  // namespace mariotte::scene
