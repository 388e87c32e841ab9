#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include "mariotte/impact/laws/icr_table.hpp"

namespace mariotte::impact {
namespace {

using Spacing = TableAxis::Spacing;

constexpr const char* first_line = "# mariotte icr-table 1, accuracy ";
constexpr std::array<const char*, 3> spacings = {"linear", "log", "exact"};

[[noreturn]] void reject(std::size_t line, const std::string& why) {
  throw InvalidParameter("icr table, line " + std::to_string(line) + ": " + why);
}

std::string exact(double value) {
  std::array<char, 32> text;
  const auto [end, problem] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

double number(std::size_t line, const std::string& text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    reject(line, "'" + text + "' is no finite number");
  return value;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> list;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) list.push_back(cell);
  return list;
}

TableAxis axis(std::size_t line, const std::string& cell) {
  const auto colon = cell.find(':');
  const auto spacing = std::find(spacings.begin(), spacings.end(), cell.substr(colon + 1));
  if (colon == std::string::npos || spacing == spacings.end())
    reject(line, "'" + cell + "' should be an axis, name:linear, name:log or name:exact");
  return {.name = cell.substr(0, colon),
          .spacing = static_cast<Spacing>(spacing - spacings.begin()),
          .values = {}};
}

/// Axes up to the column e.
void read_header(IcrTable& table, std::size_t line, const std::string& text) {
  for (const auto& cell : cells(text)) {
    if (cell == "e") return;
    table.axis.push_back(axis(line, cell));
  }
  reject(line, "there is no column 'e'");
}

void read_point(IcrTable& table, std::size_t line, const std::string& text) {
  const auto row = cells(text);
  const std::size_t axes = table.axis.size();
  if (row.size() < axes + 1) reject(line, "too few columns");
  for (std::size_t a = 0; a < axes; ++a) {
    auto& values = table.axis[a].values;
    const double value = number(line, row[a]);
    if (values.empty() || value > values.back()) values.push_back(value);
  }
  TablePoint point{.energy_ratio = number(line, row[axes]), .share = {}};
  for (std::size_t i = axes + 1; i < row.size(); ++i) point.share.push_back(number(line, row[i]));
  table.point.push_back(std::move(point));
}

/// Value of an axis at the point of this number.
double value_at(const IcrTable& table, std::size_t a, std::size_t number) {
  std::size_t faster = 1;
  for (std::size_t b = a + 1; b < table.axis.size(); ++b) faster *= table.axis[b].values.size();
  return table.axis[a].values[number / faster % table.axis[a].values.size()];
}

/// The rows are the grid of the values found, the last axis fastest.
void expect_grid(const IcrTable& table, const std::vector<std::string>& rows, std::size_t first) {
  validate(table);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t a = 0; a < table.axis.size(); ++a)
      if (number(first + i, cells(rows[i])[a]) != value_at(table, a, i))
        reject(first + i, "the points are no grid with its last axis fastest");
}

}  // namespace

void validate(const IcrTable& table) {
  const auto expect = [](bool holds, const std::string& rule) {
    if (!holds) throw InvalidParameter("icr table: " + rule);
  };
  expect(!table.axis.empty(), "there is no axis");
  std::size_t points = 1;
  bool exact_only = true;
  for (const auto& [name, spacing, values] : table.axis) {
    const bool interpolated = spacing != Spacing::exact;
    exact_only = exact_only && !interpolated;
    expect(!values.empty(), "axis " + name + " has no value");
    expect(std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end(),
           "the values of axis " + name + " do not rise");
    expect(!interpolated || values.size() != 2, "axis " + name + " needs one value, or at least three");
    expect(spacing != Spacing::log || values.front() > 0, "axis " + name + " needs positive values");
    points *= values.size();
  }
  expect(points == table.point.size(), "the number of points is not that of the grid");
  const TablePoint* first = nullptr;
  for (const auto& point : table.point) {
    if (point.share.empty()) continue;
    if (!first) first = &point;
    expect(exact_only || point.share.size() == first->share.size(), "points differ in their contacts");
  }
}

std::string write(const IcrTable& table) {
  validate(table);
  std::string text = first_line + exact(table.accuracy) + "\n# " + table.about + "\n";
  std::size_t contacts = 0;
  for (const auto& point : table.point) contacts = std::max(contacts, point.share.size());
  for (const auto& axis : table.axis)
    text += axis.name + ":" + spacings[static_cast<std::size_t>(axis.spacing)] + ",";
  text += "e";
  for (std::size_t j = 1; j <= contacts; ++j) text += ",share_" + std::to_string(j);
  text += "\n";
  for (std::size_t i = 0; i < table.point.size(); ++i) {
    for (std::size_t a = 0; a < table.axis.size(); ++a) text += exact(value_at(table, a, i)) + ",";
    text += exact(table.point[i].energy_ratio);
    for (const double share : table.point[i].share) text += "," + exact(share);
    text += "\n";
  }
  return text;
}

IcrTable parse_icr_table(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  IcrTable table;
  const std::string start = first_line;
  if (!std::getline(stream, line) || !line.starts_with(start)) reject(1, "this is no table of this version");
  table.accuracy = number(1, line.substr(start.size()));
  if (!std::getline(stream, line) || !line.starts_with("# ")) reject(2, "there is no line about the table");
  table.about = line.substr(2);
  if (!std::getline(stream, line)) reject(3, "there is no header");
  read_header(table, 3, line);
  std::vector<std::string> rows;
  while (std::getline(stream, line)) {
    rows.push_back(line);
    read_point(table, 3 + rows.size(), line);
  }
  expect_grid(table, rows, 4);
  return table;
}

}  // namespace mariotte::impact
