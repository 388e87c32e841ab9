#include "mariotte/study/sweep/design_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "mariotte/core/quantity.hpp"
#include "mariotte/model/fault.hpp"
#include "mariotte/scene/field.hpp"
#include "mariotte/scene/key_path.hpp"
#include "mariotte/scene/sweep_shape.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/sweep/formula_reader.hpp"

namespace mariotte::study {
namespace {

using scene::Document;
using scene::Domain;
using scene::Field;
using scene::Node;
using scene::Source;

/// What the scene reader took each parameter's value for: the dimension of a number, or something else.
using Meaning = std::vector<std::optional<Dimension>>;

std::vector<Field> tables(const Document& document) {
  const auto list = find(Field{&document.tree, ""}, "sweep");
  if (!list)
    reject(document.source, scene::Place{}, fault::no_sweep,
           "the scene has no [[sweep]] that says what to vary");
  expect_sweeps(document.source, *list);
  std::vector<Field> all;
  for (Index i = 0; i < static_cast<Index>(list->node->array()->size()); ++i)
    all.push_back(element(*list, i));
  return all;
}

/// Those of the tables that vary something, or those that derive a key from others.
std::vector<Field> varied(const Document& document) {
  auto all = tables(document);
  std::erase_if(all, [](const Field& table) { return find(table, "expression").has_value(); });
  return all;
}
std::vector<Field> derived(const Document& document) {
  auto all = tables(document);
  std::erase_if(all, [](const Field& table) { return !find(table, "expression"); });
  return all;
}

/// Of its own tables a sweep can vary nothing, and one key cannot have two values.
void expect_key(const Source& source, const Field& field, std::vector<std::string>& known) {
  const auto key = text(source, field);
  for (const auto* own : {"sweep", "columns"})
    if (key.starts_with(own)) reject(source, field, fault::sweep_key, "'" + key + "' cannot be varied");
  if (std::find(known.begin(), known.end(), key) != known.end())
    reject(source, field, fault::sweep_key, "'" + key + "' is varied twice");
  known.push_back(key);
}

Design read_keys(Document& document) {
  Design design;
  std::vector<std::string> known;
  const auto& source = document.source;
  for (const auto& table : varied(document)) {
    const auto variable = find(table, "variable");
    const auto key = variable ? *variable : *find(table, "key");
    expect_key(source, key, known);
    design.parameters.push_back(
        {.key = text(source, key), .place = key.place(), .is_variable = variable.has_value()});
  }
  if (design.parameters.empty())
    reject(source, tables(document).front(), fault::sweep_values, "no table says what is varied");
  for (const auto& table : derived(document)) expect_key(source, *find(table, "key"), known);
  for (const auto& one : design.parameters)
    if (!one.is_variable) locate(source, document.tree, one.key, one.place);
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

/// What says the first or last value of a range; of a distribution, its mean.
Field end_of(const Field& table, bool last) {
  const auto mean = find(table, "mean");
  return mean ? *mean : *find(table, last ? "to" : "from");
}

std::vector<Node> raw_values(const std::vector<Field>& tables, bool last) {
  std::vector<Node> raw;
  for (const auto& table : tables)
    if (const auto list = find(table, "values"))
      raw.push_back(last ? list->node->array()->back() : list->node->array()->front());
    else
      raw.push_back(*end_of(table, last).node);
  return raw;
}

/// Nothing if the scene is accepted, else why not.
std::optional<scene::SceneError> rejection(const Document& document, scene::ReadingLog* watch = nullptr) {
  try {
    resolve(document, scene::Purpose::simulation, watch);
    return {};
  } catch (const scene::SceneError& error) {
    return error;
  }
}

Meaning add(Meaning meaning, const Meaning& more) {
  for (std::size_t i = 0; i < meaning.size(); ++i)
    if (!meaning[i]) meaning[i] = more[i];
  return meaning;
}

struct Trial {
  Meaning meaning;
  std::optional<scene::SceneError> rejection;
};

/// What the reader makes of the first or last values of all parameters, as they are written.
Trial attempt(Document document, const Design& design, bool last) {
  assign(document, design, raw_values(varied(document), last));
  scene::ReadingLog watch;
  for (const auto& one : design.parameters)
    watch.readings.push_back(
        {.node = one.is_variable ? nullptr : &locate(document.source, document.tree, one.key, one.place)});
  Trial trial{.meaning = {}, .rejection = rejection(document, &watch)};
  for (const auto& reading : watch.readings) trial.meaning.push_back(reading.dimension);
  return trial;
}

/// Refuses what cannot be right: a unit that means two things, or a scene that is wrong at both ends.
Meaning read_meaning(const Document& document, const Design& design) {
  const auto first = attempt(document, design, false), last = attempt(document, design, true);
  if (first.rejection && last.rejection) throw scene::SceneError(*first.rejection);
  for (std::size_t i = 0; i < design.parameters.size(); ++i)
    if (first.meaning[i] && last.meaning[i] && !same(*first.meaning[i], *last.meaning[i]))
      reject(document.source, design.parameters[i].place, fault::sweep_key,
             "the unit of '" + design.parameters[i].key + "' depends on another key that is varied");
  return add(first.meaning, last.meaning);
}

double end(const Source& source, const Field& table, const char* name, const Dimension& dimension) {
  return number(source, *find(table, name), dimension, Domain::finite);
}

/// How many values a step makes; the last one is never beyond the end by more than rounding. Warns if it is
/// not the end.
Index steps(Source& source, const Field& field, const Range& range, const Dimension& dimension) {
  const double step = number(source, field, dimension, Domain::finite);
  const double count = (range.to - range.from) / step;
  if (range.logarithmic)
    reject(source, field, fault::sweep_values, "does not go with scale = \"log\" (give 'count')");
  if (!(count >= 0)) reject(source, field, fault::sweep_values, "does not lead from 'from' to 'to'");
  if (!(count < scene::most_points)) reject(source, field, fault::sweep_values, "makes too many values");
  const double whole = std::floor(count * (1 + 8 * epsilon));
  if (count - whole > 8 * epsilon * count)
    warn(source, field,
         fmt::format("does not lead to 'to' in whole steps; the last value is {:.10g}",
                     range.from + whole * step));
  return static_cast<Index>(whole) + 1;
}

void read_ends(const Source& source, const Field& table, const Dimension& dimension, Range& range) {
  range.normal = find(table, "mean").has_value();
  if (!range.normal) {
    range.from = end(source, table, "from", dimension);
    range.to = end(source, table, "to", dimension);
    return;
  }
  const double middle = end(source, table, "mean", dimension);
  const double half = number(source, *find(table, "deviation"), dimension, Domain::positive);
  range.from = middle - half;
  range.to = middle + half;
}

Index read_range(Source& source, const Field& table, const Dimension& dimension, Range& range) {
  read_ends(source, table, dimension, range);
  if (const auto scale = find(table, "scale")) range.logarithmic = text(source, *scale) == "log";
  if (range.logarithmic && !(range.from * range.to > 0))
    reject(source, *find(table, "from"), fault::sweep_values,
           "a scale that is \"log\" needs ends of the same sign, and not 0");
  if (const auto seed = find(table, "random"))
    range.seed = static_cast<std::uint64_t>(number(source, *seed, dimension::none, Domain::finite));
  if (const auto design = find(table, "design")) {
    const auto word = text(source, *design);
    range.draw = word == "latin" ? Draw::latin : word == "sobol" ? Draw::sobol : Draw::independent;
  }
  if (const auto field = find(table, "count")) return whole(source, *field, 1, scene::most_points);
  const auto step = *find(table, "step");
  const Index count = steps(source, step, range, dimension);
  range.to = range.from + static_cast<double>(count - 1) * number(source, step, dimension, Domain::finite);
  return count;
}

Index read_list(const Source& source, const Field& list, const std::optional<Dimension>& dimension,
                std::vector<Node>& values) {
  for (Index i = 0; i < static_cast<Index>(list.node->array()->size()); ++i) {
    const auto field = element(list, i);
    values.push_back(*field.node);
    if (dimension) values.back().value = number(source, field, *dimension, Domain::any);
  }
  return static_cast<Index>(values.size());
}

/// How many values the table has.
Index read_values(Source& source, const Field& table, const std::optional<Dimension>& dimension,
                  Parameter& parameter) {
  if (const auto list = find(table, "values")) return read_list(source, *list, dimension, parameter.list);
  if (!dimension)
    reject(source, end_of(table, false), fault::sweep_key,
           "'" + parameter.key + "' is no number; give 'values'");
  return read_range(source, table, *dimension, parameter.range.emplace());
}

bool is_zipped(const Source& source, const Field& table) {
  const auto zip = find(table, "zip");
  return zip && boolean(source, *zip);
}

void place_on_axis(const Source& source, const Field& table, Index count, Design& design,
                   Parameter& parameter) {
  if (!is_zipped(source, table)) {
    design.axes.push_back({.count = count});
  } else {
    if (design.axes.empty())
      reject(source, *find(table, "zip"), fault::sweep_values, "there is no table before to go along with");
    if (design.axes.back().count != count)
      reject(source, table, fault::sweep_values,
             "has " + std::to_string(count) + " values, the table it goes along with " +
                 std::to_string(design.axes.back().count));
  }
  parameter.axis = static_cast<Index>(design.axes.size()) - 1;
}

void set_strides(const Source& source, const scene::Place& place, Design& design) {
  Index stride = 1;
  for (auto axis = design.axes.rbegin(); axis != design.axes.rend(); ++axis) {
    axis->stride = stride;
    if (stride > scene::most_points * 1000 / axis->count)
      reject(source, place, fault::sweep_values, "the grid has too many points");
    stride *= axis->count;
  }
}

/// A variable has the dimension of its first value.
Dimension of_variable(const Source& source, const Field& table) {
  const auto values = find(table, "values");
  const auto first = values ? element(*values, 0) : *find(table, "from");
  const auto* words = std::get_if<std::string>(&first.node->value);
  if (!words) return dimension::none;
  try {
    return parse_quantity(*words).dimension;
  } catch (const QuantityError& error) {
    reject(source, first, error.fault, error.what());
  }
}

void read_axes(Document& document, const Meaning& meaning, Design& design) {
  const auto all = varied(document);
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto& parameter = design.parameters[i];
    const auto dimension =
        parameter.is_variable ? std::optional(of_variable(document.source, all[i])) : meaning[i];
    if (dimension) parameter.unit = unit_of(*dimension);
    const Index count = read_values(document.source, all[i], dimension, parameter);
    place_on_axis(document.source, all[i], count, design, parameter);
  }
  set_strides(document.source, all.front().place(), design);
}

/// The least and the largest number, which have all others between them; each at the place it was written.
std::vector<Node> extremes(const Parameter& parameter, const Field& table) {
  if (parameter.range)
    return {{parameter.range->from, end_of(table, false).place()},
            {parameter.range->to, end_of(table, true).place()}};
  if (!is_numeric(parameter)) return {};
  const auto less = [](const Node& a, const Node& b) {
    return std::get<double>(a.value) < std::get<double>(b.value);
  };
  const auto [least, most] = std::minmax_element(parameter.list.begin(), parameter.list.end(), less);
  return {*least, *most};
}

/// Rejects a value that is wrong in itself: refused at its own place, whether it stands among the first
/// values of the others or among their last. What is wrong in some company only is for the rows to tell, and
/// so is what double precision cannot carry, which follows from all numbers together.
void expect_possible(const Document& document, const Design& design) {
  const auto all = varied(document);
  Document trial = document;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (design.parameters[i].is_variable) continue;
    for (const auto& extreme : extremes(design.parameters[i], all[i])) {
      std::optional<scene::SceneError> why;
      const auto refused = [&](Index point) {
        auto company = values(design, point);
        company[i] = extreme;
        assign(trial, design, company);
        why = rejection(trial);
        return why && why->fault.code != fault::unrepresentable.code &&
               std::string_view(why->what()).starts_with(where(document.source, extreme.place) + ": ");
      };
      if (refused(0) && refused(design.points() - 1)) throw scene::SceneError(*why);
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
  for (const auto& one : design.derived) all.push_back({number(design, one.formula, point), one.place});
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
