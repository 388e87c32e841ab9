#include "mariotte/report/table/background.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/report/csv/columns.hpp"

namespace mariotte::report {
namespace {

using impact::ValidityLimit;

std::string name(const ValidityLimit& one) {
  return one.unit == std::string_view("1") ? one.symbol : fmt::format("{} [{}]", one.symbol, one.unit);
}

std::string wanted(const ValidityLimit& one) {
  return std::isnan(one.limit) ? "" : fmt::format("{} {:g}", one.from_below ? "≤" : "≥", one.limit);
}

std::string holds(const ValidityLimit& one, const impact::Validity& validity) {
  return std::isnan(one.limit) ? "" : is_beyond(one, validity) ? "no" : "yes";
}

}  // namespace

std::string validity_table(const impact::Validity& validity, const char* thing) {
  std::vector<TableRow> rows;
  for (const auto& one : impact::validity_limits)
    if (const auto& number = validity.*one.number)
      rows.push_back({name(one), fmt::format("{:.4g}", number->value), fmt::format("{}", number->contact + 1),
                      wanted(one), holds(one, validity)});
  if (rows.empty()) return "";
  return "\nValidity\n" +
         columns({"", "value", thing, "wanted", "holds"}, std::ssize(rows), [&](Index i) { return rows[i]; });
}

std::string flows_table(const std::vector<impact::FlowUse>& flows) {
  if (flows.empty()) return "";
  const auto row = [&](Index i) -> TableRow {
    const auto& use = flows[static_cast<std::size_t>(i)];
    return {use.name, fmt::format("{}", use.phases), fmt::format("{}", use.steps),
            fmt::format("{}", use.rhs)};
  };
  return "\nFlows\n" + columns({"flow", "phases", "steps", "right-hand sides"}, std::ssize(flows), row);
}

std::string skipped_table(const std::vector<impact::Skipped>& skipped) {
  if (skipped.empty()) return "";
  std::string text = "\nNot needed\n";
  for (const auto& one : skipped) text += fmt::format("  {}: {}\n", one.what, one.why);
  return text;
}

}  // namespace mariotte::report
