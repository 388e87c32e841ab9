#include "mariotte/report/page/html_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>

#include "mariotte/core/counted.hpp"
#include "mariotte/impact/quantities/quantity.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/page/html_text.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_rows = 60;  // of a longer table the first and the last half of these

template <class Impact>
const impact::Description* find(std::string_view path) {
  for (const auto& one : impact::quantities<Impact>())
    if (one.is.key == path) return &one.is;
  return nullptr;
}

const impact::Description* find(const std::string& model, std::string_view path) {
  if (model == "chain") return find<impact::ChainImpact>(path);
  if (model == "network") return find<impact::NetworkImpact>(path);
  if (model == "bodies") return find<impact::BodiesImpact>(path);
  return model == "microbody" ? find<impact::MicrobodyImpact>(path) : nullptr;
}

/// Of a value, or of the numbers in its lists.
const impact::Description* description(const Key& key) {
  for (const char* brackets : {"", "[]", "[][]"})
    if (const auto* found = find(key.model, key.path + brackets); found && !found->unit.empty()) return found;
  return nullptr;
}

void collect(const Json& value, std::vector<double>& numbers) {
  if (value.is_number()) numbers.push_back(value.get<double>());
  if (value.is_array())
    for (const auto& one : value) collect(one, numbers);
}

Display display_of(const Json& values, const std::string& unit) {
  std::vector<double> numbers;
  collect(values, numbers);
  if (unit.empty() || unit == "1" || unit == "SI") return {.factor = 1, .unit = unit, .decimals = 0};
  return display_for(numbers, unit);
}

std::string words(std::string name) {
  const auto is_mark = [](char c) { return c == '_' || c == '.'; };
  std::replace_if(name.begin(), name.end(), is_mark, ' ');
  return name;
}

/// "f_nm [N]" with its index below.
std::string typeset(const std::string& text) {
  static const std::regex index("_([[:alnum:]]+)");
  return std::regex_replace(escaped(text), index, "<sub>$1</sub>");
}

/// "peak force max f_j [kN]"
std::string heading(const Column& column, const Display& display) {
  const bool has_unit = !display.unit.empty() && display.unit != "1";
  return "<th>" + typeset(column.name + (has_unit ? " [" + display.unit + "]" : "")) + "</th>";
}

enum class Digits { four, all };

std::string text(const Json& value, double factor, Digits digits) {
  if (value.is_number_float()) {
    const double shown = factor * value.get<double>() + 0.0;  // of -0 that makes 0
    return digits == Digits::all ? fmt::format("{}", shown) : fmt::format("{:.4g}", shown);
  }
  if (!value.is_array()) return inline_text(value);
  const auto count = digits == Digits::all ? value.size() : std::min(value.size(), most_inline);
  std::string list;
  for (std::size_t i = 0; i < count; ++i) {
    const auto inner = text(value[i], factor, digits);
    list += (list.empty() ? "" : ", ") + (value[i].is_array() ? "[" + inner + "]" : inner);
  }
  return count < value.size() ? fmt::format("{}, … ({} in all)", list, value.size()) : list;
}

bool has_more_digits(const Json& value) {
  return value.is_number_float() ||
         (value.is_array() && std::any_of(value.begin(), value.end(), has_more_digits));
}

std::string cell(const Json& value, double factor) {
  const auto title =
      has_more_digits(value) ? fmt::format(" title=\"{}\"", escaped(text(value, factor, Digits::all))) : "";
  return fmt::format("<td{}{}>{}</td>", value.is_number() ? " class=\"n\"" : "", title,
                     escaped(text(value, factor, Digits::four)));
}

std::string framed(const std::string& rows) {
  return "<div class=\"wide\"><table>\n" + rows + "</table></div>\n";
}

/// Rows 0 … count−1 as `row` writes them, the middle of many left out.
template <class Row>
std::string some(std::size_t count, std::size_t columns, const Row& row) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (count > most_rows && i == most_rows / 2) {
      const std::size_t left_out = count - most_rows;
      text += fmt::format("<tr><td colspan=\"{}\">… {} more …</td></tr>\n", columns, left_out);
      i += left_out;
    }
    text += row(i);
  }
  return text;
}

bool is_empty(const Json& values) {
  return std::all_of(values.begin(), values.end(),
                     [](const Json& one) { return one.is_null() || (one.is_array() && one.empty()); });
}

/// Whether a column is zero in every line, and no instant.
bool is_zero(const Column& one) {
  return one.unit != "s" && std::all_of(one.values.begin(), one.values.end(), [](const Json& value) {
           return value.is_number_float() && value.get<double>() == 0;
         });
}

Column column(const std::string& name, const Key& key, Json values) {
  const auto* is = description(key);
  auto title = words(name);
  if (is && !is->symbol.empty()) title += " " + std::string(is->symbol);
  return {title, is ? std::string(is->unit) : "", std::move(values)};
}

/// Members of members stand beside the others, as "losses.friction".
Json flat(const Json& object) {
  Json all;
  for (const auto& [name, value] : object.items())
    if (value.is_object())
      for (const auto& [inner, number] : value.items()) all[name + "." + inner] = number;
    else
      all[name] = value;
  return all;
}

/// A table; what is zero in every line is named below it.
std::string without_zeros(std::vector<Column> columns, const std::vector<std::size_t>& numbers) {
  const auto zero = std::stable_partition(columns.begin(), columns.end(), std::not_fn(is_zero));
  std::string names;
  for (auto one = zero; one != columns.end(); ++one)
    names += (names.empty() ? "" : ", ") + typeset(one->name);
  columns.erase(zero, columns.end());
  return (columns.empty() ? "" : table("#", columns, numbers)) +
         (names.empty() ? "" : "<p>Zero in every line: " + names + ".</p>\n");
}

/// Of bodies, all pairs of which may touch, contacts that never closed are counted below the table.
std::string of_objects(const Json& nested, const Key& key) {
  auto list = Json::array();
  std::vector<std::size_t> numbers;
  const bool is_partial = key.model == "bodies" && key.path == "contacts";
  if (is_partial)
    for (const auto i : closed_among(nested)) list.push_back(flat(nested[i])), numbers.push_back(i + 1);
  else
    for (const auto& one : nested) list.push_back(flat(one));
  std::vector<std::string> names;
  for (const auto& one : list)
    for (const auto& [name, value] : one.items())
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  std::vector<Column> columns;
  for (const auto& name : names) {
    auto values = Json::array();
    for (const auto& one : list) values.push_back(one.value(name, Json(nullptr)));
    columns.push_back(column(name, {key.model, key.path + "[]." + name}, std::move(values)));
  }
  const auto left_out = nested.size() - list.size();
  return without_zeros(std::move(columns), numbers) +
         (left_out > 0 ? fmt::format("<p>{} closed.</p>\n",
                                     counted(left_out, "other pair has never", "other pairs have never"))
                       : "");
}

/// Members that are lists of one length stand side by side, the others one below the other.
std::string of_members(const Json& object, const Key& key) {
  std::string rows, lists;
  for (const auto& [name, value] : object.items()) {
    const Key member{key.model, key.path + "." + name};
    if (value.is_array() && !value.empty() && (value.size() > most_inline || value.front().is_object())) {
      lists += "<h3>" + escaped(words(name)) + "</h3>\n" + table(value, member);
      continue;
    }
    const auto one = column(name, member, value);
    const auto display = display_of(value, one.unit);
    rows += "<tr>" + heading(one, display) + cell(value, display.factor) + "</tr>\n";
  }
  return (rows.empty() ? "" : framed(rows)) + lists;
}

}  // namespace

std::vector<std::size_t> closed_among(const Json& contacts) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (!contacts[i].contains("periods") || !contacts[i]["periods"].empty()) places.push_back(i);
  return places;
}

std::string table(const std::string& head, const std::vector<Column>& columns,
                  const std::vector<std::size_t>& numbers) {
  std::vector<const Column*> shown;
  std::vector<double> factor;
  std::string header = "<tr><th>" + escaped(head) + "</th>";
  for (const auto& one : columns) {
    if (is_empty(one.values)) continue;
    const auto display = display_of(one.values, one.unit);
    header += heading(one, display);
    factor.push_back(display.factor);
    shown.push_back(&one);
  }
  const bool is_named = columns.size() > 1 || !columns[0].name.empty();
  const std::size_t rows = columns.empty() ? 0 : columns.front().values.size();
  return framed((is_named ? header + "</tr>\n" : "") + some(rows, shown.size() + 1, [&](std::size_t i) {
                  auto row = fmt::format("<tr><td class=\"n\">{}</td>", numbers.empty() ? i + 1 : numbers[i]);
                  for (std::size_t k = 0; k < shown.size(); ++k) row += cell(shown[k]->values[i], factor[k]);
                  return row + "</tr>\n";
                }));
}

std::string table(const Json& value, const Key& key) {
  if (value.is_object()) return of_members(value, key);
  if (!value.is_array()) return "<p>" + escaped(inline_text(value)) + "</p>\n";
  if (!value.empty() && value.front().is_object()) return of_objects(value, key);
  const auto* is = description(key);
  return table("#", {{is ? std::string(is->symbol) : "", is ? std::string(is->unit) : "", value}});
}

std::string quantity(double value, const std::string& unit) {
  const auto display = display_of(Json(value), unit);
  return fmt::format("{:.4g} {}", display.factor * value, display.unit);
}

}  // namespace mariotte::report
