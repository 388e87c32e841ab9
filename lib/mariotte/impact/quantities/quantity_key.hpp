// A number of a result by the key that a user writes.
//
//     KEY = name { "." name | "[" index "]" } [ ".count" ]
//
// Indices count from 0, or from the end, where −1 is the last; * stands for all of them, ".count" is the
// length of an array.
#pragma once
#include <algorithm>
#include <limits>
#include <string>

#include "mariotte/impact/quantities/quantity.hpp"

namespace mariotte::impact {

inline constexpr Index every_index = -1;  ///< what * is

/// What −1, −2, … are; it changes into the index as written, and back.
inline constexpr Index from_end(Index written) {
  return every_index + written;
}
inline constexpr bool is_from_end(Index index) {
  return index < every_index;
}
/// Of an array of so many; negative if it is too short.
inline constexpr Index place_in(Index count, Index index) {
  return is_from_end(index) ? count + index - every_index : index;
}

/// A key in parts.
struct Key {
  std::string pattern;         ///< as in the lists: "contacts[].periods[]"
  std::vector<Index> indices;  ///< in their order; one less than the pattern has, if it `counts`
  bool counts = false;         ///< asks for the length of the array
};

/// Empty for what is no key.
std::optional<Key> parse_key(std::string_view text);

/// A quantity at a place of a result.
template <class Impact>
struct Entry {
  const Quantity<Impact>* quantity = nullptr;
  std::array<const Quantity<Impact>*, Indices().size()> arrays = {};  ///< that the indices are of, then null
  Indices at = {};
  bool counts = false;  ///< its length instead of its value

  bool has_index(std::size_t level) const { return level < arrays.size() && arrays[level]; }
};

template <class Impact>
const Quantity<Impact>* find_quantity(std::string_view pattern) {
  for (const auto& one : quantities<Impact>())
    if (one.is.key == pattern) return &one;
  return nullptr;
}

/// Empty if no result of the kind has this key: the pattern is unknown, or its indices are too many or few.
template <class Impact>
std::optional<Entry<Impact>> find_entry(const Key& key) {
  Entry<Impact> entry;
  entry.quantity = find_quantity<Impact>(key.pattern);
  entry.counts = key.counts;
  if (!entry.quantity || !(key.counts ? entry.quantity->count != nullptr : entry.quantity->read != nullptr))
    return std::nullopt;
  for (std::size_t from = 0, level = 0; level < key.indices.size(); ++level) {
    from = key.pattern.find("[]", from) + 2;
    entry.arrays[level] = find_quantity<Impact>(std::string_view(key.pattern).substr(0, from));
    entry.at[level] = key.indices[level];
  }
  return entry;
}

/// Count indices from the end from 0, of the first `levels` arrays; false where this result has no such
/// place.
template <class Impact>
bool find_place(Entry<Impact>& entry, const Impact& impact, std::size_t levels = Indices().size()) {
  for (std::size_t level = 0; level < levels && entry.has_index(level); ++level) {
    const Index count = entry.arrays[level]->count(impact, entry.at).value_or(0);
    entry.at[level] = place_in(count, entry.at[level]);
    if (entry.at[level] < 0 || entry.at[level] >= count) return false;
  }
  return true;
}

/// The value as a number; nan if it is none.
double number(const Value& value);

/// Nan where this result has nothing there.
template <class Impact>
double number(Entry<Impact> entry, const Impact& impact) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!find_place(entry, impact)) return none;
  if (!entry.counts) return number(entry.quantity->read(impact, entry.at));
  const auto count = entry.quantity->count(impact, entry.at);
  return count ? static_cast<double>(*count) : none;
}

/// Whether the quickest solver has it.
template <class Impact>
bool is_brief(const Entry<Impact>& entry) {
  if (std::any_of(entry.at.begin(), entry.at.end(), is_from_end)) return false;
  return entry.quantity->brief && entry.counts == !entry.quantity->read;
}

/// The same number, if it `is_brief`.
template <class Impact>
double number(const Entry<Impact>& entry, const Brief<Impact>& brief) {
  return number(entry.quantity->brief(brief, entry.at));
}

}  // namespace mariotte::impact
