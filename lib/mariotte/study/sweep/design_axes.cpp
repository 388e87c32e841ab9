#include "mariotte/study/sweep/design_axes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/core/counted.hpp"
#include "mariotte/core/quantity.hpp"
#include "mariotte/scene/sweep_shape.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/sweep/sweep_tables.hpp"

namespace mariotte::study {

using scene::Document;
using scene::Domain;
using scene::Field;
using scene::Node;
using scene::Source;

namespace {

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
             "has " + counted(count, "value") + ", the table it goes along with " +
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

/// Of a key, or an element of it.
bool is_angle(std::string_view key) {
  const auto name = key.substr(0, key.rfind('['));
  return name.ends_with("angle") || name.ends_with("angles") || name.ends_with("phase");
}

}  // namespace

std::string unit_of_key(std::string_view key, const Dimension& dimension) {
  if (key.ends_with("frequency")) return "Hz";
  if (is_angle(key)) return "rad";
  return key.ends_with("work_of_adhesion") ? "J/m^2" : unit_of(dimension);
}

void read_axes(Document& document, const Meaning& meaning, Design& design) {
  const auto all = varied(document);
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto& parameter = design.parameters[i];
    const auto dimension =
        parameter.is_variable ? std::optional(of_variable(document.source, all[i])) : meaning[i];
    if (dimension)
      parameter.unit = parameter.is_variable ? unit_of(*dimension) : unit_of_key(parameter.key, *dimension);
    const Index count = read_values(document.source, all[i], dimension, parameter);
    place_on_axis(document.source, all[i], count, design, parameter);
  }
  set_strides(document.source, all.front().place(), design);
}

}  // namespace mariotte::study
