#include "measuring/reference_table.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace mariotte::measuring {
namespace {

Fields split(const std::string& line) {
  Fields fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

}  // namespace

std::vector<Fields> rows(std::string_view csv) {
  std::vector<Fields> table;
  std::istringstream in{std::string(csv)};
  bool header = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (!header) table.push_back(split(line));
    header = false;
  }
  return table;
}

long double number(const std::string& field) {
  return std::strtold(field.c_str(), nullptr);
}

std::vector<long double> numbers(const Fields& row, std::size_t from) {
  std::vector<long double> values;
  std::transform(row.begin() + static_cast<std::ptrdiff_t>(from), row.end(), std::back_inserter(values),
                 number);
  return values;
}

}  // namespace mariotte::measuring
