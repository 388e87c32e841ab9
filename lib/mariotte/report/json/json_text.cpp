#include <cmath>
#include <nlohmann/json.hpp>

#include "mariotte/report/json/json.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

// A float keeps its point, so that a reader with typed numbers does not take 1.0 for an integer.
std::string number(double value) {
  if (!std::isfinite(value)) return "null";
  const std::string digits = exact(value);
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string scalar(const Json& value) {
  if (value.is_number_float()) return number(value.get<double>());
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// The result itself and lists of objects take a line per entry; everything below stays on its line.
bool one_per_line(const Json& value, int depth) {
  if (value.empty()) return false;
  return depth == 0 || (depth == 1 && value.is_array() && value.front().is_object());
}

void write(const Json& value, int depth, std::string& out) {
  if (!value.is_structured()) {
    out += scalar(value);
    return;
  }
  const bool lines = one_per_line(value, depth);
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  const std::string before = lines ? "\n" + indent + "  " : "";
  out += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, entry] : value.items()) {
    if (!first) out += lines ? "," : ", ";
    first = false;
    out += before;
    if (value.is_object()) out += scalar(key) + ": ";
    write(entry, depth + 1, out);
  }
  if (lines) out += "\n" + indent;
  out += value.is_object() ? '}' : ']';
}

}  // namespace

std::string text(const Json& json) {
  std::string out;
  write(json, 0, out);
  return out + "\n";
}

}  // namespace mariotte::report
