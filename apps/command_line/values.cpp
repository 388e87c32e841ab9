#include "command_line/values.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "command_line/exit_code.hpp"
#include "mariotte/core/quantity.hpp"
#include "mariotte/flow/choose.hpp"

namespace mariotte::command {

std::optional<double> number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string> split(const std::string& text, char separator) {
  if (text.empty()) return {""};
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

double quantity(const std::string& option, const std::string& text, const Dimension& dimension) {
  try {
    return parse_quantity(text, dimension);
  } catch (const QuantityError& problem) {
    throw UsageError(option + ": " + problem.what());
  }
}

double positive_quantity(const std::string& option, const std::string& text, const Dimension& dimension) {
  const double value = quantity(option, text, dimension);
  if (value > 0 && std::isfinite(value)) return value;
  throw UsageError(option + ": must be positive and finite, not " + text);
}

std::string is_accuracy(const std::string& text) {
  const auto value = number(text);
  return value && *value > 0 && *value < 1 ? "" : "must be a number between 0 and 1, not " + text;
}

std::string is_flow(const std::string& text) {
  try {
    flow::parse_kind(text);
    return "";
  } catch (const InvalidParameter& problem) {
    return problem.what();
  }
}

std::string is_file_name(const std::string& text) {
  return text == "-" ? "'-' is no name of a file" : "";
}

}  // namespace mariotte::command
