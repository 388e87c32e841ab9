#include "mariotte/scene/result_key.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace mariotte::scene {
namespace {

/// The value of a key of a table, or null.
const Node* member(const Node* node, std::string_view key) {
  const auto* table = node ? node->table() : nullptr;
  const auto* entry = table ? find(*table, key) : nullptr;
  return entry ? &entry->node : nullptr;
}

/// The `number` of an element of a list of tables, or 0.
std::int64_t number_of(const Node* list, std::size_t index) {
  const auto* array = list ? list->array() : nullptr;
  const auto* number = array && index < array->size() ? member(&(*array)[index], "number") : nullptr;
  const auto* value = number ? std::get_if<std::int64_t>(&number->value) : nullptr;
  return value ? *value : 0;
}

bool lists_balls(std::string_view name) {
  constexpr std::array of_balls = {"mass", "radius", "diameter", "velocity", "material"};
  return std::find(of_balls.begin(), of_balls.end(), name) != of_balls.end();
}

bool has_left_wall(const Node* chain) {
  const auto* wall = member(chain, "wall");
  const auto* where = wall ? std::get_if<std::string>(&wall->value) : nullptr;
  return where && (*where == "left" || *where == "both");
}

}  // namespace

std::string key_in_results(const Document& document, const std::string& key) {
  const auto dot = key.find('.'), open = key.find('['), close = key.find(']');
  if (close == key.npos || open == key.npos || open < dot) return key;
  const auto* section = member(&document.tree, key.substr(0, dot));
  const auto name = key.substr(dot + 1, open - dot - 1);
  const auto index = static_cast<std::size_t>(std::atoll(key.c_str() + open + 1));
  const auto number = number_of(member(section, name), index);
  const auto shift = lists_balls(name) && has_left_wall(section) ? 1 : 0;
  const auto place = number > 0 ? static_cast<std::size_t>(number) - 1 : index + shift;
  return key.substr(0, open + 1) + std::to_string(place) + key.substr(close);
}

}  // namespace mariotte::scene
