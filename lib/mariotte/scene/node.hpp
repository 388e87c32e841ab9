// A scene file as a tree of values that remember where they were written.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mariotte::scene {

/// Where a value or key was written: line and column in the file, or another origin, as a `--set`.
struct Place {
  int line = 1;
  int column = 1;
  int origin = -1;  ///< index among the origins of the source, or −1 for the file
};

struct Node;
struct Entry;

using Array = std::vector<Node>;
using Table = std::vector<Entry>;  ///< in the order of the file

/// One TOML value.
struct Node {
  std::variant<bool, std::int64_t, double, std::string, Array, Table> value;
  Place place;

  const Array* array() const { return std::get_if<Array>(&value); }
  const Table* table() const { return std::get_if<Table>(&value); }
  Array* array() { return std::get_if<Array>(&value); }
  Table* table() { return std::get_if<Table>(&value); }
};

/// A key of a table and its value.
struct Entry {
  std::string key;
  Place place;
  Node node;
};

/// The entry of this key, or nullptr.
const Entry* find(const Table& table, std::string_view key);
Entry* find(Table& table, std::string_view key);

/// "a number", "a string", "an array" …
const char* kind(const Node& node);

}  // namespace mariotte::scene
