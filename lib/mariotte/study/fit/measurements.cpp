#include "mariotte/study/fit/measurements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "mariotte/core/nearest.hpp"
#include "mariotte/core/quantity.hpp"
#include "mariotte/impact/quantities/quantity_key.hpp"
#include "mariotte/scene/csv_table.hpp"
#include "mariotte/scene/text_file.hpp"
#include "mariotte/study/fault.hpp"

namespace mariotte::study {
namespace {

using scene::Cell;
using scene::Source;

constexpr std::array<std::string_view, 8> words{
    "speed",     "diameter", "restitution", "restitution.tip", "restitution.centre",
    "deviation", "ending",   "reason"};
constexpr std::array<std::string_view, 7> tables{"body.",    "surface.", "incidence.", "chain.",
                                                 "network.", "bodies.",  "run."};

/// A column of the header, "name [unit]".
struct Column {
  std::string name, unit;
  std::size_t number;  ///< from 0
};

/// Which columns are what.
struct Columns {
  std::vector<Column> settings;
  std::optional<Column> measured, deviation;
};

Column split(const Cell& cell, std::size_t number) {
  const auto bracket = cell.text.rfind(" [");
  if (bracket == std::string::npos || !cell.text.ends_with(']')) return {cell.text, "", number};
  const auto end = cell.text.find_last_not_of(' ', bracket) + 1;
  return {cell.text.substr(0, end), cell.text.substr(bracket + 2, cell.text.size() - bracket - 3), number};
}

/// The description of a result's number; null if no result has it.
const impact::Description* described(const std::string& name) {
  const auto key = impact::parse_key(name);
  if (!key) return nullptr;
  if (const auto chain = impact::find_entry<impact::ChainImpact>(*key)) return &chain->quantity->is;
  if (const auto network = impact::find_entry<impact::NetworkImpact>(*key)) return &network->quantity->is;
  if (const auto bodies = impact::find_entry<impact::BodiesImpact>(*key)) return &bodies->quantity->is;
  const auto body = impact::find_entry<impact::MicrobodyImpact>(*key);
  return body ? &body->quantity->is : nullptr;
}

bool is_quantity(const std::string& name) {
  return name == "restitution" || described(name);
}

Dimension dimension_of(const std::string& quantity) {
  const auto* is = described(quantity);
  if (!is || is->unit == "1" || is->unit.empty()) return dimension::none;
  return parse_quantity("1 " + std::string(is->unit)).dimension;
}

std::string key_of(const std::string& name) {
  if (name == "speed") return "incidence.normal_speed";
  return name == "diameter" ? "body.radius" : name;
}

bool is_key(const std::string& name) {
  return name == "speed" || name == "diameter" ||
         std::any_of(tables.begin(), tables.end(), [&](auto table) { return name.starts_with(table); });
}

void place_once(const Source& source, const Cell& cell, const Column& column, std::optional<Column>& place) {
  if (place) reject(source, cell.place, fault::wrong_columns, "'" + place->name + "' is given, too");
  place = column;
}

/// What was meant: a unit in other brackets, or without a space before them, or a word with a typo.
std::string hint(const std::string& name) {
  const auto bracket = name.find_first_of("[(");
  if (bracket == std::string::npos || bracket == 0 || !(name.ends_with(']') || name.ends_with(')')))
    return suggestion(name, words);
  const auto word = name.substr(0, name.find_last_not_of(' ', bracket - 1) + 1);
  return "; units stand in brackets behind a space, as in '" + word + " [" +
         name.substr(bracket + 1, name.size() - bracket - 2) + "]'";
}

Columns read_header(const Source& source, const std::vector<Cell>& header) {
  Columns columns;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto column = split(header[i], i);
    if (is_quantity(column.name))
      place_once(source, header[i], column, columns.measured);
    else if (column.name == "deviation")
      place_once(source, header[i], column, columns.deviation);
    else if (is_key(column.name))
      columns.settings.push_back(column);
    else if (column.name != "ending" && column.name != "reason")
      reject(source, header[i].place, fault::wrong_columns,
             "'" + column.name +
                 "' is no column of measurements, as speed, diameter, restitution and "
                 "deviation are, and no key of a scene or a result" +
                 hint(column.name));
  }
  return columns;
}

void expect_complete(const Source& source, const std::vector<Cell>& header, const Columns& columns) {
  if (!columns.measured)
    reject(source, header.front().place, fault::wrong_columns, "the column 'restitution' is missing");
  if (columns.settings.empty())
    reject(source, header.front().place, fault::wrong_columns,
           "no column says what differs between the rows, as 'speed' does");
  for (auto one = columns.settings.begin(); one != columns.settings.end(); ++one)
    for (auto other = columns.settings.begin(); other != one; ++other)
      if (key_of(other->name) == key_of(one->name))
        reject(source, header[one->number].place, fault::wrong_columns,
               "'" + (other->name == one->name ? one->name : key_of(one->name)) +
                   "' is set by another column, too");
}

/// A number with something behind it.
bool has_unit(const std::string& text) {
  constexpr std::string_view digits = "0123456789.";
  return !text.empty() && (digits.find(text.front()) != digits.npos || text.front() == '-') &&
         digits.find(text.back()) == digits.npos;
}

std::string with_unit(const Source& source, const Cell& cell, const Column& column) {
  if (cell.text.empty())
    reject(source, cell.place, fault::missing, "the value of '" + column.name + "' is missing");
  if (column.unit.empty()) return cell.text;
  if (has_unit(cell.text))
    reject(source, cell.place, fault::unknown_unit,
           "the header gives the unit already: '" + column.unit + "'");
  return cell.text + " " + column.unit;
}

double number(const Source& source, const Cell& cell, const std::string& text, const Dimension& dimension) {
  try {
    const double value = parse_quantity(text, dimension);
    if (!std::isfinite(value)) reject(source, cell.place, fault::out_of_range, "must be finite");
    return value;
  } catch (const QuantityError& error) {
    reject(source, cell.place, error.fault, error.what());
  }
}

scene::Node value(const Source& source, const Cell& cell, const Column& column) {
  const auto text = with_unit(source, cell, column);
  if (column.name != "diameter") return {.value = text, .place = cell.place};
  return {.value = 0.5 * number(source, cell, text, dimension::length), .place = cell.place};
}

/// A tip that gains speed has been pushed by something else, but for what noise makes of restitutions near 0
/// and 1: to leave these out would move the others. A mass centre may gain speed, out of the spin.
void expect_possible(const Source& source, const Cell& cell, const Column& column, double value) {
  const bool is_restitution = column.name == "restitution" || column.name == "restitution.tip";
  constexpr double noise = 0.1;
  if (is_restitution && !(value >= -noise && value <= 1 + noise))
    reject(source, cell.place, fault::out_of_range,
           "a restitution must be between 0 and 1, but for noise of up to 0.1" +
               std::string(value > 2 ? " (45 % is 0.45)" : ""));
}

Measurement read_row(const Source& source, const std::vector<Cell>& cells, const Columns& columns) {
  const auto measured = [&](const Column& column) {
    const auto& cell = cells[column.number];
    return number(source, cell, with_unit(source, cell, column), dimension_of(columns.measured->name));
  };
  Measurement row{.place = cells.front().place, .written = {}, .values = {}};
  for (const auto& column : columns.settings) {
    row.written.push_back(with_unit(source, cells[column.number], column));
    row.values.push_back(value(source, cells[column.number], column));
  }
  row.measured = measured(*columns.measured);
  expect_possible(source, cells[columns.measured->number], *columns.measured, row.measured);
  if (!columns.deviation) return row;
  row.deviation = measured(*columns.deviation);
  if (!(row.deviation > 0))
    reject(source, cells[columns.deviation->number].place, fault::out_of_range, "must be positive");
  return row;
}

}  // namespace

Measurements parse_measurements(const std::string& text, const std::string& name) {
  const Source source{.name = name, .origins = {}};
  const auto table = scene::parse_csv(source, text);
  const auto columns = read_header(source, table.header);
  expect_complete(source, table.header, columns);
  Measurements measurements{.file = name,
                            .settings = {},
                            .quantity = columns.measured->name,
                            .quantity_place = table.header[columns.measured->number].place,
                            .weighted = columns.deviation.has_value(),
                            .rows = {}};
  for (const auto& column : columns.settings)
    measurements.settings.push_back({.name = column.name,
                                     .key = key_of(column.name),
                                     .unit = {},
                                     .place = table.header[column.number].place});
  for (const auto& cells : table.rows) measurements.rows.push_back(read_row(source, cells, columns));
  return measurements;
}

Measurements read_measurements(const std::string& path) {
  return parse_measurements(scene::read_text(path), path);
}

}  // namespace mariotte::study
