#include "mariotte/report/csv/csv_cell.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "mariotte/report/number.hpp"

namespace mariotte::report {

std::string cell(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string cell(const std::string& key, std::string_view unit) {
  const bool tells = !unit.empty() && unit != "1" && unit != "SI";
  return cell(tells ? key + " [" + std::string(unit) + "]" : key);
}

void split(std::string_view line, std::vector<std::string>& cells) {
  std::size_t count = 0, at = 0;
  do {
    if (cells.size() == count) cells.emplace_back();
    auto& text = cells[count++];
    text.clear();
    bool quoted = false;
    for (; at < line.size() && (quoted || line[at] != ','); ++at) {
      if (line[at] != '"') text += line[at];
      if (line[at] == '"' && quoted && line.substr(at + 1).starts_with('"'))
        text += line[++at];
      else if (line[at] == '"')
        quoted = !quoted;
    }
  } while (at++ < line.size());
  cells.resize(count);
}

double number(std::string_view cell) {
  double value = 0;
  const auto [stop, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool is_number = problem == std::errc() && stop == cell.data() + cell.size();
  return is_number ? value : std::numeric_limits<double>::quiet_NaN();
}

void append_value(const scene::Node& node, std::string& text) {
  if (const auto* real = std::get_if<double>(&node.value))
    append_exact(*real, text);
  else if (const auto* integer = std::get_if<std::int64_t>(&node.value))
    text += std::to_string(*integer);
  else if (const auto* truth = std::get_if<bool>(&node.value))
    text += *truth ? "true" : "false";
  else if (const auto* words = std::get_if<std::string>(&node.value))
    text += cell(*words);
}

}  // namespace mariotte::report
