// The known name a misspelt one probably stood for.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace mariotte {

/// The candidate with the fewest edits (insert, delete, replace, swap of neighbours; a changed case is half
/// an edit) from `word`, or "" if even that one is too far to be meant. The first wins among equals.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// " (did you mean 'stiffness'?)", or "" if nothing is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace mariotte
