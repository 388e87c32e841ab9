#include "mariotte/report/page/html_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mariotte::report {
namespace {

constexpr std::size_t most_rows = 60;  // of a longer table the first and the last half of these
constexpr std::size_t most_inline = 12;

std::string cell(const Json& value) {
  return fmt::format("<td{}>{}</td>", value.is_number() ? " class=\"n\"" : "", escaped(inline_text(value)));
}

std::string head(const std::vector<std::string>& names) {
  std::string text = "<tr>";
  for (const auto& name : names) text += "<th>" + escaped(name) + "</th>";
  return text + "</tr>\n";
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

std::string of_objects(const Json& list) {
  std::vector<std::string> names;
  for (const auto& one : list)
    for (const auto& [name, value] : one.items())
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  auto all = names;
  all.insert(all.begin(), "#");
  return framed(head(all) + some(list.size(), all.size(), [&](std::size_t i) {
                  auto row = fmt::format("<tr><td class=\"n\">{}</td>", i + 1);
                  for (const auto& name : names) row += cell(list[i].value(name, Json(nullptr)));
                  return row + "</tr>\n";
                }));
}

std::string of_values(const Json& list) {
  return framed(some(list.size(), 2, [&](std::size_t i) {
    return fmt::format("<tr><td class=\"n\">{}</td>{}</tr>\n", i + 1, cell(list[i]));
  }));
}

/// Members that are lists of one length stand side by side, the others one below the other.
std::string of_members(const Json& object) {
  std::string rows, lists;
  for (const auto& [name, value] : object.items())
    if (value.is_array() && value.size() > most_inline)
      lists += "<h3>" + escaped(name) + "</h3>\n" + table(value);
    else
      rows += "<tr><th>" + escaped(name) + "</th>" + cell(value) + "</tr>\n";
  return (rows.empty() ? "" : framed(rows)) + lists;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string inline_text(const Json& value) {
  if (value.is_null()) return "–";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.8g}", value.get<double>());
  if (!value.is_array()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string text;
  for (std::size_t i = 0; i < std::min(value.size(), most_inline); ++i) {
    const auto& one = value[i];
    text += (text.empty() ? "" : ", ") + (one.is_array() ? "[" + inline_text(one) + "]" : inline_text(one));
  }
  return value.size() > most_inline ? fmt::format("{}, … ({} in all)", text, value.size()) : text;
}

std::string table(const Json& value) {
  if (value.is_object()) return of_members(value);
  if (!value.is_array()) return "<p>" + escaped(inline_text(value)) + "</p>\n";
  return !value.empty() && value.front().is_object() ? of_objects(value) : of_values(value);
}

}  // namespace mariotte::report
