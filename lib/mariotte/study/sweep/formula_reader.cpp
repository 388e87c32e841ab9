#include "mariotte/study/sweep/formula_reader.hpp"

#include <algorithm>
#include <array>

#include "mariotte/core/nearest.hpp"
#include "mariotte/scene/field.hpp"
#include "mariotte/scene/key_path.hpp"

namespace mariotte::study {
namespace {

constexpr std::array<std::string_view, 7> input_tables{"chain",   "network",   "body", "bodies",
                                                       "surface", "incidence", "run"};

template <class List>
std::optional<std::size_t> place_of(const std::string& key, const List& list) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.key == key; });
  if (found == list.end()) return {};
  return static_cast<std::size_t>(found - list.begin());
}

/// Whether `key` is of something inside of `whole`.
bool is_inside(const std::string& key, const std::string& whole) {
  return key.size() > whole.size() && key.starts_with(whole) &&
         (key[whole.size()] == '.' || key[whole.size()] == '[');
}

/// The keys of all values of a scene that are no tables or arrays.
void add_keys(const scene::Node& node, const std::string& key, std::vector<std::string>& keys) {
  if (const auto* const table = node.table())
    for (const auto& entry : *table)
      add_keys(entry.node, key.empty() ? entry.key : key + "." + entry.key, keys);
  else if (const auto* const array = node.array())
    for (std::size_t i = 0; i < array->size(); ++i)
      add_keys((*array)[i], key + "[" + std::to_string(i) + "]", keys);
  else
    keys.push_back(key);
}

/// What a name that stands for nothing was meant to be; nothing if the scene has it, but as no number.
std::string suggested_name(const std::string& name, const scene::Document& document, const Design& design) {
  std::vector<std::string> keys;
  for (const auto& one : design.parameters) keys.push_back(one.key);
  for (const auto& one : design.derived) keys.push_back(one.key);
  add_keys(document.tree, "", keys);
  if (std::find(keys.begin(), keys.end(), name) != keys.end()) return "";
  return suggestion(name, std::vector<std::string_view>(keys.begin(), keys.end()));
}

/// A number as the scene reader takes it [SI]; empty if the scene gives none.
std::optional<double> given(const std::string& name, scene::Document document) try {
  scene::Node& node = locate(document.source, document.tree, name, {});
  scene::ReadingLog watch{.readings = {{.node = &node, .dimension = {}}}};
  try {
    resolve(document, scene::Purpose::simulation, &watch);
  } catch (const scene::SceneError&) {  // told elsewhere
  }
  const auto& dimension = watch.readings[0].dimension;
  if (!dimension) return {};
  return number(document.source, {&node, name}, *dimension, scene::Domain::any);
} catch (const scene::SceneError&) {
  return {};
}

}  // namespace

bool is_input(const std::string& name, const Design& design) {
  const auto table = name.substr(0, name.find_first_of(".["));
  return std::find(input_tables.begin(), input_tables.end(), table) != input_tables.end() ||
         place_of(name, design.parameters) || place_of(name, design.derived);
}

Term input_term(const std::string& name, const scene::Document& document, const Design& design) {
  if (const auto which = place_of(name, design.parameters)) {
    if (!is_numeric(design.parameters[*which]))
      throw ExpressionError("'" + name + "' is not always a number");
    return {.kind = Term::Kind::parameter, .which = *which};
  }
  if (const auto which = place_of(name, design.derived))
    return {.kind = Term::Kind::derived, .which = *which};
  for (const auto& one : design.parameters)
    if (is_inside(name, one.key) || is_inside(one.key, name))
      throw ExpressionError("'" + name + "' and '" + one.key + "', which is varied, overlap");
  const auto value = given(name, document);
  if (!value)
    throw ExpressionError("'" + name + "' is no number that the scene gives" +
                          suggested_name(name, document, design));
  return {.value = *value};
}

Formula read_formula(const std::string& text, const scene::Document& document, const Design& design) {
  Formula formula{.expression = Expression(text), .terms = {}};
  for (const auto& name : formula.expression.names())
    formula.terms.push_back(input_term(name, document, design));
  return formula;
}

}  // namespace mariotte::study
