#include "mariotte/scene/idle_keys.hpp"

#include <algorithm>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/scene/contact_law.hpp"

namespace mariotte::scene {
namespace {

using contact::NamedLaw;

void add_names(const Node& node, std::vector<std::string_view>& names) {
  if (const auto* name = std::get_if<std::string>(&node.value)) names.push_back(*name);
  if (const auto* list = node.array())
    for (const auto& one : *list) add_names(one, names);
}

/// Of the whole and of its contacts.
std::vector<std::string_view> laws_named_in(const Field& whole) {
  std::vector<std::string_view> names;
  if (const auto law = find(whole, "law")) add_names(*law->node, names);
  const auto contacts = find(whole, "contact");
  if (contacts && contacts->node->array())
    for (const auto& one : *contacts->node->array())
      if (const auto* law = one.table() ? find(*one.table(), "law") : nullptr) add_names(law->node, names);
  return names;
}

bool knows(const NamedLaw& law, std::string_view key) {
  if (key == "relaxation_time") return law.relaxation;
  if (key == "table") return law.has_table;
  return law.find(key);
}

/// Those that are refused by the laws that they have no meaning for, or belong to any.
bool is_common(std::string_view key) {
  constexpr std::array<std::string_view, 6> common{"law",         "damping", "exponent",
                                                   "restitution", "at",      "separation"};
  return std::ranges::find(common, key) != common.end();
}

}  // namespace

void warn_of_idle_keys(Source& source, const Field& whole) {
  const auto names = laws_named_in(whole);
  const auto is_used = [&](const NamedLaw& law) { return std::ranges::find(names, law.name) != names.end(); };
  for (const auto key : law_keys) {
    const auto field = find(whole, key);
    if (!field || is_common(key)) continue;
    const auto takes = [&](const NamedLaw& law) { return is_used(law) && knows(law, key); };
    if (std::none_of(contact::named_laws.begin(), contact::named_laws.end(), takes))
      warn(source, *field, "has no effect: no contact has a law with this number");
  }
}

}  // namespace mariotte::scene
