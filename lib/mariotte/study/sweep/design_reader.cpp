#include "mariotte/study/sweep/design_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mariotte/scene/field.hpp"
#include "mariotte/scene/key_path.hpp"
#include "mariotte/scene/result_key.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/sweep/design_axes.hpp"
#include "mariotte/study/sweep/design_trials.hpp"
#include "mariotte/study/sweep/expression.hpp"
#include "mariotte/study/sweep/formula_reader.hpp"
#include "mariotte/study/sweep/sweep_tables.hpp"

namespace mariotte::study {
namespace {

using scene::Document;
using scene::Field;
using scene::Node;
using scene::Source;

/// Of its own tables a sweep can vary nothing, and one key cannot have two values.
void expect_key(const Source& source, const Field& field, std::vector<std::string>& known) {
  const auto key = text(source, field);
  for (const auto* own : {"sweep", "columns"})
    if (key.starts_with(own)) reject(source, field, fault::sweep_key, "'" + key + "' cannot be varied");
  if (std::find(known.begin(), known.end(), key) != known.end())
    reject(source, field, fault::sweep_key, "'" + key + "' is varied twice");
  known.push_back(key);
}

/// The name of a variable heads a column, too.
void expect_free(const Source& source, const Field& field) {
  const auto name = text(source, field);
  if (!is_name(name)) reject(source, field, fault::sweep_key, "'" + name + "' is no name in expressions");
  if (name == "ending" || name == "reason")
    reject(source, field, fault::sweep_key, "'" + name + "' is a column of every sweep");
}

Design read_keys(Document& document) {
  Design design;
  std::vector<std::string> known;
  const auto& source = document.source;
  for (const auto& table : varied(document)) {
    const auto variable = find(table, "variable");
    const auto key = variable ? *variable : *find(table, "key");
    expect_key(source, key, known);
    if (variable) expect_free(source, key);
    design.parameters.push_back(
        {.key = text(source, key), .place = key.place(), .is_variable = variable.has_value()});
  }
  if (design.parameters.empty())
    reject(source, tables(document).front(), fault::sweep_values, "no table says what is varied");
  for (const auto& table : derived(document)) expect_key(source, *find(table, "key"), known);
  for (auto& one : design.parameters) {
    if (one.is_variable) continue;
    locate(source, document.tree, one.key, one.place);
    one.key_in_results = scene::key_in_results(document, one.key);
  }
  return design;
}

/// Expressions take the place of values that the scene has.
void read_derived(Document& document, Design& design) {
  for (const auto& table : derived(document)) {
    const auto key = *find(table, "key"), expression = *find(table, "expression");
    const auto name = text(document.source, key);
    if (locate(document.source, document.tree, name, key.place()).table())
      reject(document.source, key, fault::sweep_key, "'" + name + "' needs a value in the scene, too");
    try {
      design.derived.push_back(
          {name, expression.place(), read_formula(text(document.source, expression), document, design)});
    } catch (const ExpressionError& error) {
      reject(document.source, expression, error.fault, error.what());
    }
  }
}

}  // namespace

void assign(Document& document, const Design& design, const std::vector<Node>& values) {
  const auto put = [&](const std::string& key, const scene::Place& place, const Node& value) {
    locate(document.source, document.tree, key, place) = value;
  };
  const std::size_t varied = design.parameters.size();
  for (std::size_t i = 0; i < varied; ++i)
    if (const auto& one = design.parameters[i]; !one.is_variable) put(one.key, one.place, values[i]);
  for (std::size_t i = varied; i < values.size(); ++i)
    put(design.derived[i - varied].key, design.derived[i - varied].place, values[i]);
}

std::vector<Node> values(const Design& design, Index point) {
  std::vector<Node> all;
  for (std::size_t i = 0; i < design.parameters.size(); ++i) all.push_back(value(design, i, point));
  for (const auto& one : design.derived) {
    auto& node = all.emplace_back();
    const double found = number(design, one.formula, point);
    node.value = std::isfinite(found) ? found : std::numeric_limits<double>::quiet_NaN();  // never a wall
    node.place = one.place;
  }
  return all;
}

Design read_design(Document& document) {
  Design design = read_keys(document);
  read_axes(document, read_meaning(document, design), design);
  assign(document, design, values(design, 0));
  read_derived(document, design);
  assign(document, design, values(design, 0));
  expect_possible(document, design);
  return design;
}

}  // namespace mariotte::study
