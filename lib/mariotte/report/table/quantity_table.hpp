// Quantities in tables: units and numbers come from the list of what a result says.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mariotte/impact/quantities/quantity_key.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {

/// Numbers of one quantity, one below the other.
struct NumberColumn {
  std::string name;
  Display display = {};
  std::vector<double> values = {};

  std::string head() const { return name + " [" + display.unit + "]"; }
  std::string cell(Index row) const { return std::isnan(values[row]) ? "–" : shown(display, values[row]); }
};

/// Of a member that all elements of an array have, "contacts[].impulse", with so many digits less than usual.
template <class Impact>
NumberColumn number_column(std::string name, std::string_view key, const Impact& result, int less = 0) {
  const auto& quantity = *impact::find_quantity<Impact>(key);
  const auto& array = *impact::find_quantity<Impact>(key.substr(0, key.find("[]") + 2));
  NumberColumn column{.name = std::move(name)};
  for (Index i = 0; i < array.count(result, {}).value_or(0); ++i)
    column.values.push_back(impact::number(quantity.read(result, {i})));
  column.display = display_for(column.values, std::string(quantity.is.unit));
  column.display.decimals = std::max(0, column.display.decimals - less);
  return column;
}

/// A line of a balance: what is written before the number, and what it is.
struct BalanceLine {
  const char* name;
  std::string_view key;
  bool unless_zero = false;
};

/// ", 1.4e-12 estimated", of the error of a result; empty where there is none, or nothing bounds it.
std::string estimate(const std::optional<double>& accuracy);

/// The residual of a balance in the unit of its table, and as a share of `scale` unless that is 0.
std::string residual_line(const Display& display, double residual, double scale);

/// The lines in one unit, then the residual.
template <class Impact>
std::string balance_table(const char* title, const Impact& result, std::span<const BalanceLine> lines,
                          std::string_view residual, double scale = 0) {
  const auto value = [&](std::string_view key) {
    return impact::number(impact::find_quantity<Impact>(key)->read(result, {}));
  };
  std::vector<double> values;
  for (const auto& one : lines) values.push_back(value(one.key));
  const auto display = display_for(values, std::string(impact::find_quantity<Impact>(residual)->is.unit));
  std::string text = std::string("\n") + title + " [" + display.unit + "]\n";
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (values[i] != 0 || !lines[i].unless_zero) text += line(lines[i].name, shown(display, values[i]));
  return text + residual_line(display, value(residual), scale);
}

}  // namespace mariotte::report
