#include "mariotte/scene/key_path.hpp"

#include <charconv>
#include <string>
#include <vector>

#include "mariotte/core/nearest.hpp"

namespace mariotte::scene {
namespace {

constexpr std::size_t most_steps = 16;

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

  [[noreturn]] void fail(const std::string& message) const {
    reject(source_, place_, fault::leads_nowhere, message, std::string(key_));
  }

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

/// What a scene may leave to other keys, and has no elements then; or a key that is near to a misspelt one.
std::string where_from(std::string_view name, const std::string& parent, const Table& known) {
  if (name == "stiffness")
    return " (it follows from radii and materials; a list, stiffness = [...], has elements that can vary)";
  if (name == "gap") return " (one gap for all, or none, has no elements; a list, gap = [...], has)";
  if (parent == "chain" && name != "ball" && find(known, "ball"))
    return " (tables [[chain.ball]] say it of a ball: chain.ball[0]." + std::string(name) + ")";
  if (name != "contact" || parent.empty()) {
    std::vector<std::string_view> names;
    for (const auto& entry : known) names.push_back(entry.key);
    return suggestion(name, names);
  }
  if (parent == "network") return " (contacts of balls share the keys of [network])";
  return " (a table [[" + parent + ".contact]] has what is different at one contact)";
}

Node& member(Node& node, std::string_view name, const Path& path, const std::string& parent,
             const Place& place) {
  Table* const table = node.table();
  if (!table) path.fail("'" + parent + "' is " + kind(node) + ", not a table");
  if (Entry* const entry = find(*table, name)) return entry->node;
  if (path.index_follows())
    path.fail("the scene has no '" + path.walked() + "'" + where_from(name, parent, *table));
  table->push_back({std::string(name), place, Node{Table{}, place}});
  return table->back().node;
}

}  // namespace

Node& locate(const Source& source, Node& root, std::string_view key, const Place& place) {
  Path path(source, place, key);
  Node* node = &root;
  do {
    const auto parent = path.walked();
    const auto step = path.next();
    node = step.name.empty() ? &element(*node, step.index, path, parent)
                             : &member(*node, step.name, path, parent, place);
  } while (!path.at_end());
  return *node;
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

}  // namespace mariotte::scene
