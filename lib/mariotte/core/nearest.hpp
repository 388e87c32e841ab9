// The known name a misspelt one probably stood for.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mariotte {

/// The candidate with the fewest edits (insert, delete, replace, swap of neighbours; a changed case is half
/// an edit) from `word`, or "" if even that one is too far to be meant. The first wins among equals.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// The candidates that may be meant, at most `count`, likeliest first: those that hold the word or that it
/// holds, then those with the fewest edits, however many.
std::vector<std::string_view> nearest_few(std::string_view word, std::span<const std::string_view> candidates,
                                          std::size_t count);

/// " (did you mean 'stiffness'?)", or "" if nothing else is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

/// The same, or " (nearest: run, fit, law)" if nothing is near; "" of no candidates.
std::string suggestion_or_few(std::string_view word, std::span<const std::string_view> candidates);

/// As `suggestion` of paths, as "chain.radius": one that ends like `word` is nearer than any misspelling.
std::string suggested_path(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace mariotte
