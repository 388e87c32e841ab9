#include "mariotte/scene/overrides.hpp"

#include <charconv>

#include "mariotte/scene/toml.hpp"

namespace mariotte::scene {
namespace {

constexpr std::size_t most_steps = 16;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// One step of a path: a name, or an index if the name is empty.
struct Step {
  std::string_view name;
  std::size_t index = 0;
};

/// Walks a path and remembers how far it came, for messages.
class Path {
 public:
  Path(const Source& source, Place place, std::string_view key)
      : source_(source), place_(place), key_(key), rest_(key) {}

  bool at_end() const { return rest_.empty(); }
  std::string walked() const { return std::string(key_.substr(0, key_.size() - rest_.size())); }
  bool index_follows() const { return rest_.starts_with('['); }

  Step next() {
    if (++steps_ > most_steps) fail("the key has too many parts");
    return index_follows() ? index() : name();
  }

  [[noreturn]] void fail(const std::string& message) const { reject(source_, place_, message); }

 private:
  Step name() {
    if (!walked().empty()) {
      if (rest_.front() != '.') bad();
      rest_.remove_prefix(1);
    }
    const auto found = rest_.substr(0, rest_.find_first_of(".["));
    const auto letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    if (found.empty() || found.find_first_not_of(letters) != std::string_view::npos) bad();
    rest_.remove_prefix(found.size());
    return {.name = found};
  }

  Step index() {
    std::size_t value = 0;
    const char* const end = rest_.data() + rest_.size();
    const auto [stop, error] = std::from_chars(rest_.data() + 1, end, value);
    if (error != std::errc() || stop == end || *stop != ']') bad();
    rest_.remove_prefix(static_cast<std::size_t>(stop + 1 - rest_.data()));
    return {.name = {}, .index = value};
  }

  [[noreturn]] void bad() const { fail("cannot read the key (write it like chain.contact[0].stiffness)"); }

  const Source& source_;
  Place place_;
  std::string_view key_;
  std::string_view rest_;
  std::size_t steps_ = 0;
};

Node& element(Node& node, std::size_t index, const Path& path, const std::string& parent) {
  Array* const array = node.array();
  if (!array) path.fail("'" + parent + "' is " + kind(node) + ", not an array");
  if (index >= array->size())
    path.fail("no element " + std::to_string(index) + ": '" + parent + "' has " +
              std::to_string(array->size()) + " (counted from 0)");
  return (*array)[index];
}

Node& member(Node& node, std::string_view name, const Path& path, const std::string& parent,
             const Place& place) {
  Table* const table = node.table();
  if (!table) path.fail("'" + parent + "' is " + kind(node) + ", not a table");
  if (Entry* const entry = find(*table, name)) return entry->node;
  if (path.index_follows()) path.fail("the scene has no '" + path.walked() + "'");
  table->push_back({std::string(name), place, Node{Table{}, place}});
  return table->back().node;
}

void move_to(const Place& place, Node& node) {
  node.place = place;
  if (Array* const array = node.array())
    for (auto& one : *array) move_to(place, one);
  if (Table* const table = node.table())
    for (auto& [key, key_place, value] : *table) {
      key_place = place;
      move_to(place, value);
    }
}

Node parse_value(std::string_view text, const Place& place) {
  Node value{std::string(text), place};
  try {
    Node document = parse_toml({}, "value = " + std::string(text));
    if (document.table()->size() == 1 && document.table()->front().key == "value")
      value = std::move(document.table()->front().node);
  } catch (const SceneError&) {
    // Not TOML: it stays a string, so that units need no quotes within the shell's.
  }
  move_to(place, value);
  return value;
}

void apply(const std::string& override, Source& source, Node& root) {
  const auto equals = override.find('=');
  const auto key = trimmed(std::string_view(override).substr(0, equals));
  const Place place{.set = static_cast<int>(source.set_keys.size())};
  source.set_keys.emplace_back(key);
  if (equals == std::string::npos) reject(source, place, "expected KEY=VALUE");

  Path path(source, place, source.set_keys.back());
  Node* node = &root;
  do {
    const auto parent = path.walked();
    const auto step = path.next();
    node = step.name.empty() ? &element(*node, step.index, path, parent)
                             : &member(*node, step.name, path, parent, place);
  } while (!path.at_end());
  *node = parse_value(trimmed(std::string_view(override).substr(equals + 1)), place);
}

}  // namespace

void apply(const Overrides& overrides, Source& source, Node& root) {
  for (const auto& override : overrides) apply(override, source, root);
}

}  // namespace mariotte::scene
