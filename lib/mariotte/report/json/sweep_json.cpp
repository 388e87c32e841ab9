#include "mariotte/report/json/sweep_json.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/json/column_statistics.hpp"
#include "mariotte/report/json/json_parts.hpp"

namespace mariotte::report {
namespace {

Json varied(const study::Design& design, const study::Parameter& parameter) {
  Json one = {{"key", parameter.key},
              {"axis", parameter.axis},
              {"count", design.axes[static_cast<std::size_t>(parameter.axis)].count}};
  if (!parameter.unit.empty()) one["unit"] = parameter.unit;
  if (!parameter.range) {
    one["values"] = list(parameter.list, json_of_value);
    return one;
  }
  if (parameter.range->normal)
    one.update({{"mean", mean(*parameter.range)}, {"deviation", deviation(*parameter.range)}});
  else
    one.update({{"from", parameter.range->from},
                {"to", parameter.range->to},
                {"scale", parameter.range->logarithmic ? "log" : "linear"}});
  if (!parameter.range->seed) return one;
  one["random"] = *parameter.range->seed;
  one["design"] = name(parameter.range->draw);
  return one;
}

/// Of the rows that have a word in common.
struct Occurrence {
  Index points = 0;
  Index row = 0;  ///< the first, from 1
};

using Occurrences = std::map<std::string, Occurrence>;

void add(const std::string& word, Index row, Occurrences& all) {
  auto& one = all[word];
  if (one.points++ == 0) one.row = row;
}

Json json(const Occurrences& all, const char* name) {
  std::vector<std::pair<std::string, Occurrence>> sorted(all.begin(), all.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second.points > b.second.points; });
  return list(sorted, [&](const auto& one) {
    return Json{{name, one.first}, {"points", one.second.points}, {"first_row", one.second.row}};
  });
}

}  // namespace

Json json(const study::SweepPlan& plan, Index failed) {
  auto result = Json{{"title", plan.title}, {"points", plan.design.points()}, {"failed", failed}};
  result["varied"] = list(plan.design.parameters, [&](const auto& one) { return varied(plan.design, one); });
  if (!plan.design.derived.empty())
    result["derived"] = list(plan.design.derived, [](const study::Derived& one) {
      return Json{{"key", one.key}, {"expression", one.formula.expression.text()}};
    });
  result["provenance"] = provenance_json(plan.document.sha256);
  result["provenance"]["columns"] = list(
      plan.columns, [](const study::Column& one) { return one.written.empty() ? one.key : one.written; });
  return result;
}

Json summary(std::istream& csv) {
  std::string line;
  std::vector<std::string> cells;
  std::getline(csv, line);
  ColumnStatistics numbers(line);
  const std::size_t columns = numbers.columns();
  Occurrences endings, reasons;
  for (Index row = 1; std::getline(csv, line); ++row) {
    numbers.add(line);
    split(line, cells);
    if (cells.size() != columns + 2) continue;
    add(cells[columns], row, endings);
    if (!cells.back().empty()) add(cells.back(), row, reasons);
  }
  return {{"columns", numbers.json()},
          {"endings", json(endings, "ending")},
          {"reasons", json(reasons, "reason")}};
}

}  // namespace mariotte::report
