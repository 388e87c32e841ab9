// Keeps from the TOML parser what it does not survive.
//
// toml++ 3.3 trusts its input in a few places: some characters outside strings, and deep nesting, end in an
// assertion or in undefined behaviour instead of a parse error. Nothing of it is needed in a scene.
#pragma once
#include <string_view>

#include "mariotte/scene/source.hpp"

namespace mariotte::scene {

/// Throws SceneError with line and column unless the text is UTF-8 without control characters; made of ASCII
/// letters, digits, blanks and _ - + . , : = # [ ] { } ' " outside strings and comments; with strings that
/// end and have only ASCII right after a backslash; with strings and brackets that start after a blank or one
/// of = , [ {; with one = per key; with values without quotes that are numbers, true or false, each up to a
/// comma, a closing bracket or the end of the line; with brackets at most 16 deep and keys of at most 16
/// parts.
void guard_toml(const Source& source, std::string_view text);

}  // namespace mariotte::scene
