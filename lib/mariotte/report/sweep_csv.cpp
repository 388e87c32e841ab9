#include "mariotte/report/sweep_csv.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

// RFC 4180: quoted where it has to be. A row is a line, whatever a message holds.
std::string cell(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
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

void append_parameter(const study::Design& design, std::size_t parameter, Index point, std::string& text) {
  if (design.parameters[parameter].range)
    append_exact(number(design, parameter, point), text);
  else
    append_value(value(design, parameter, point), text);
}

}  // namespace

std::string sweep_header(const study::Design& design, const std::vector<std::string>& columns) {
  std::string text;
  for (const auto& parameter : design.parameters) text += cell(parameter.key) + ",";
  for (const auto& column : columns) text += cell(column) + ",";
  return text + "ending,reason\n";
}

void append_rows(const study::Design& design, const study::Batch& batch, std::string& text) {
  const std::size_t rows = batch.verdicts.size(), columns = rows ? batch.numbers.size() / rows : 0;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < design.parameters.size(); ++i) {
      append_parameter(design, i, batch.first + static_cast<Index>(row), text);
      text += ',';
    }
    for (std::size_t i = 0; i < columns; ++i) {
      const double number = batch.numbers[row * columns + i];
      if (!std::isnan(number)) append_exact(number, text);
      text += ',';
    }
    const auto& verdict = batch.verdicts[row];
    ((text += verdict.ending) += ',') += cell(verdict.reason);
    text += '\n';
  }
}

}  // namespace mariotte::report
