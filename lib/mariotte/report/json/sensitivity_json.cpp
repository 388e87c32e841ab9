#include "mariotte/report/json/sensitivity_json.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/core/counted.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {

void add_slopes(const impact::Sensitivity& slopes, Json& result) {
  Json names = Json::array(), values = Json::array(), derivative = Json::object();
  for (const auto& [name, value] : slopes.parameter) {
    names.push_back(name);
    values.push_back(value);
  }
  for (const auto& outcome : slopes.outcome) {
    const auto row = list(outcome.slope, nullable);
    if (outcome.index)
      derivative[outcome.name].push_back(row);
    else
      derivative[outcome.name] = row;
  }
  result["parameters"] = std::move(names);
  result["parameter_values"] = std::move(values);
  result["derivative"] = std::move(derivative);
  result["swept_back"] = slopes.is_swept_back;
  result["notes"] = texts(slopes.notes);
}

namespace {

std::string relative(const impact::OutcomeSlopes& outcome, double slope, double parameter) {
  if (!outcome.value || *outcome.value == 0 || parameter == 0) return "–";
  return fmt::format("{:+.4g}", slope * parameter / *outcome.value + 0.0);
}

std::string rows(const impact::Sensitivity& slopes, const impact::OutcomeSlopes& outcome) {
  const auto row = [&](Index i) -> TableRow {
    const auto& [name, value] = slopes.parameter[static_cast<std::size_t>(i)];
    const auto& slope = outcome.slope[static_cast<std::size_t>(i)];
    if (!slope) return {name, rounded(value, 6), "none", "–"};
    return {name, rounded(value, 6), fmt::format("{:+.10g}", *slope + 0.0), relative(outcome, *slope, value)};
  };
  const auto value = outcome.value ? rounded(*outcome.value, 10) + " " + outcome.unit : "undefined";
  return fmt::format("\n{} = {}\n", name_of(outcome), value) +
         columns({"by", "value [SI]", "slope [SI]", "% per %"}, std::ssize(slopes.parameter), row);
}

}  // namespace

std::string table(const impact::Sensitivity& slopes, const std::string& title) {
  std::string text = fmt::format("{}\n{} · slopes by {}{}\n", title.empty() ? "Sensitivity" : title,
                                 hybrid::name(slopes.ending), counted(slopes.parameter.size(), "parameter"),
                                 slopes.is_swept_back ? ", swept back" : "");
  for (const auto& outcome : slopes.outcome) text += rows(slopes, outcome);
  for (const auto& note : slopes.notes) text += "\nnote: " + note.text + "\n";
  return text;
}

std::string csv(const impact::Sensitivity& slopes) {
  std::string text = "outcome,unit,value";
  for (const auto& one : slopes.parameter) text += "," + one.name;
  text += "\n";
  for (const auto& outcome : slopes.outcome) {
    text +=
        fmt::format("{},{},{}", name_of(outcome), outcome.unit, outcome.value ? exact(*outcome.value) : "");
    for (const auto& slope : outcome.slope) text += "," + (slope ? exact(*slope) : "");
    text += "\n";
  }
  return text;
}

}  // namespace mariotte::report
