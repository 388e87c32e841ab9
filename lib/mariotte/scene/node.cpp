#include "mariotte/scene/node.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace mariotte::scene {

const Entry* find(const Table& table, std::string_view key) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Entry& one) { return one.key == key; });
  return found == table.end() ? nullptr : &*found;
}

Entry* find(Table& table, std::string_view key) {
  return const_cast<Entry*>(find(std::as_const(table), key));
}

const char* kind(const Node& node) {
  // In the order of the variant.
  constexpr std::array names{"a boolean", "a number", "a number", "a string", "an array", "a table"};
  return names[node.value.index()];
}

}  // namespace mariotte::scene
