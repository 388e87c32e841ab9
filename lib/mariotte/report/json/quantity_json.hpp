// The quantities of a result as JSON: its keys are their paths.
#pragma once
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/impact/quantities/quantity.hpp"
#include "mariotte/report/json/json_stream.hpp"

namespace mariotte::report {

/// Writes a value; a result that has no such key writes null where it stands in an array.
struct ValueWriter {
  JsonStream& out;

  void operator()(std::monostate) const { out.value(nullptr); }
  void operator()(impact::Omitted) const { out.value(nullptr); }
  void operator()(double value) const { out.number(value); }
  void operator()(Index value) const { out.whole(value); }
  void operator()(std::string_view words) const { out.value(std::string(words)); }
  void operator()(bool value) const { out.value(value); }
};

/// The list of an impact as a tree of keys: "contacts[].periods[][]" is contacts, [], periods, [], [].
template <class Impact>
class QuantityTree {
 public:
  QuantityTree() {
    for (const auto& quantity : impact::quantities<Impact>()) insert(quantity);
  }
  /// All of them, as members of the object that is open.
  void write(const Impact& impact, JsonStream& out) const {
    impact::Indices at = {};
    for (const auto& one : root_.inner) write_member(one, {impact, out, at}, 0);
  }

 private:
  struct Node {
    std::string_view name = {};
    std::string member = {};  ///< "\"name\": "
    const impact::Quantity<Impact>* quantity = nullptr;
    std::vector<Node> inner = {};

    bool is_array() const { return inner.size() == 1 && inner[0].name == "[]"; }
  };
  struct Place {
    const Impact& impact;
    JsonStream& out;
    impact::Indices& at;
  };

  void insert(const impact::Quantity<Impact>& quantity) {
    auto* node = &root_;
    for (std::string_view path = quantity.is.key; !path.empty();) {
      const auto end = path.starts_with("[]") ? 2 : std::min(path.find_first_of(".["), path.size());
      node = &child(*node, path.substr(0, end));
      path.remove_prefix(end);
      if (path.starts_with('.')) path.remove_prefix(1);
    }
    node->quantity = &quantity;
  }
  static Node& child(Node& node, std::string_view name) {
    for (auto& one : node.inner)
      if (one.name == name) return one;
    return node.inner.emplace_back(Node{.name = name, .member = '"' + std::string(name) + "\": "});
  }

  /// Whether a result has it, or anything in it.
  static bool is_there(const Node& node, const Place& place) {
    if (node.is_array()) return true;
    if (node.inner.empty())
      return !std::holds_alternative<impact::Omitted>(node.quantity->read(place.impact, place.at));
    return std::any_of(node.inner.begin(), node.inner.end(),
                       [&](const Node& one) { return is_there(one, place); });
  }

  /// A number in some results and an array in others, as a spin in the plane and in space.
  static bool is_scalar(const Node& node, const Place& place) {
    return node.is_array() && node.quantity && node.quantity->read &&
           !std::holds_alternative<impact::Omitted>(node.quantity->read(place.impact, place.at));
  }

  static void write_member(const Node& node, const Place& place, std::size_t level) {
    if (node.inner.empty() && !is_there(node, place)) return;
    place.out.ready_key(node.member);
    write_value(node, place, level);
  }
  static void write_value(const Node& node, const Place& place, std::size_t level) {
    if (is_scalar(node, place))
      return std::visit(ValueWriter{place.out}, node.quantity->read(place.impact, place.at));
    if (node.is_array()) return write_array(node.inner[0], place, level);
    if (node.inner.empty())
      return std::visit(ValueWriter{place.out}, node.quantity->read(place.impact, place.at));
    if (!is_there(node, place)) return place.out.value(nullptr);
    place.out.open_object();
    for (const auto& one : node.inner) write_member(one, place, level);
    place.out.close();
  }
  static void write_array(const Node& element, const Place& place, std::size_t level) {
    const auto count = element.quantity->count(place.impact, place.at);
    if (!count) return place.out.value(nullptr);
    place.out.open_array();
    for (place.at[level] = 0; place.at[level] < *count; ++place.at[level])
      write_value(element, place, level + 1);
    place.out.close();
  }

  Node root_;
};

}  // namespace mariotte::report
