#include "mariotte/report/csv/sweep_csv.hpp"

#include <cmath>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

void append_parameter(const study::Design& design, std::size_t parameter, Index point, std::string& text) {
  if (design.parameters[parameter].range)
    append_exact(number(design, parameter, point), text);
  else
    append_value(value(design, parameter, point), text);
}

}  // namespace

std::string sweep_header(const study::Design& design, const std::vector<study::Column>& columns) {
  std::string text;
  const auto add = [&](const auto& one) { text += cell(one.key, one.unit) + ","; };
  for (const auto& parameter : design.parameters) add(parameter);
  for (const auto& column : columns) add(column);
  return text + "ending,reason\n";
}

std::string key_of_column(const std::string& name) {
  const auto bracket = name.rfind(" [");
  return bracket == name.npos || !name.ends_with(']') ? name : name.substr(0, bracket);
}

std::string unit_of_column(const std::string& name) {
  const auto key = key_of_column(name).size();
  return key == name.size() ? "1" : name.substr(key + 2, name.size() - key - 3);
}

void append_parameters(const study::Design& design, Index point, std::string& text) {
  for (std::size_t i = 0; i < design.parameters.size(); ++i) {
    append_parameter(design, i, point, text);
    text += ',';
  }
}

void append_rows(const study::Design& design, const study::Batch& batch, std::string& text) {
  const std::size_t rows = batch.verdicts.size(), columns = rows ? batch.numbers.size() / rows : 0;
  for (std::size_t row = 0; row < rows; ++row) {
    append_parameters(design, batch.first + static_cast<Index>(row), text);
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
