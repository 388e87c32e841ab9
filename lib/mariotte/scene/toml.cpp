#include "mariotte/scene/toml.hpp"

#include <algorithm>
#include <stdexcept>

#include "mariotte/scene/toml_guard.hpp"

// toml++ is compiled here, not taken from a shared library that may be built with its assertions on: one of
// them would end the program over a typing error. The guard keeps out what would trip them.
#undef TOML_SHARED_LIB
#undef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(condition) static_assert(true)
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace mariotte::scene {
namespace {

Place place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Node convert(const toml::node& node);

Table convert_table(const toml::table& from) {
  Table table;
  for (const auto& [key, value] : from)
    table.push_back({std::string(key.str()), place_of(key.source()), convert(value)});
  const auto earlier = [](const Entry& a, const Entry& b) {
    return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
  };
  std::stable_sort(table.begin(), table.end(), earlier);
  return table;
}

Array convert_array(const toml::array& from) {
  Array array;
  array.reserve(from.size());
  for (const auto& value : from) array.push_back(convert(value));
  return array;
}

Node convert(const toml::node& node) {
  const Place place = place_of(node.source());
  switch (node.type()) {
    case toml::node_type::boolean:
      return {node.as_boolean()->get(), place};
    case toml::node_type::integer:
      return {node.as_integer()->get(), place};
    case toml::node_type::floating_point:
      return {node.as_floating_point()->get(), place};
    case toml::node_type::string:
      return {node.as_string()->get(), place};
    case toml::node_type::array:
      return {convert_array(*node.as_array()), place};
    case toml::node_type::table:
      return {convert_table(*node.as_table()), place};
    default:
      throw std::logic_error("a date has passed the guard");
  }
}

}  // namespace

Node parse_toml(const Source& source, std::string_view text) {
  guard_toml(source, text);
  try {
    return convert(toml::parse(text));
  } catch (const toml::parse_error& error) {
    reject(source, place_of(error.source()), fault::not_toml,
           "not valid TOML: " + std::string(error.description()));
  }
}

}  // namespace mariotte::scene
