#include "mariotte/report/json/sweep_json.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/json/json_parts.hpp"

namespace mariotte::report {
namespace {

Json varied(const study::Design& design, const study::Parameter& parameter) {
  Json one = {{"key", parameter.key},
              {"axis", parameter.axis},
              {"count", design.axes[static_cast<std::size_t>(parameter.axis)].count}};
  if (!parameter.range) {
    one["values"] = list(parameter.list, json_of_value);
    return one;
  }
  one.update({{"from", parameter.range->from},
              {"to", parameter.range->to},
              {"scale", parameter.range->logarithmic ? "log" : "linear"}});
  if (parameter.range->seed) one["random"] = *parameter.range->seed;
  return one;
}

/// Of the cells of one column that are numbers.
struct Numbers {
  std::string key;
  Index count = 0;
  double least = 0, greatest = 0;

  void add(const std::string& cell) {
    const double value = number(cell);
    if (std::isnan(value)) return;
    least = count == 0 ? value : std::min(least, value);
    greatest = count == 0 ? value : std::max(greatest, value);
    ++count;
  }
};

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

Json json(const Numbers& column) {
  const bool any = column.count > 0;
  return {{"key", column.key},
          {"numbers", column.count},
          {"least", any ? Json(column.least) : Json(nullptr)},
          {"greatest", any ? Json(column.greatest) : Json(nullptr)}};
}

}  // namespace

Json json(const study::SweepPlan& plan, Index failed) {
  auto result = Json{{"title", plan.title}, {"points", plan.design.points()}, {"failed", failed}};
  result["varied"] = list(plan.design.parameters, [&](const auto& one) { return varied(plan.design, one); });
  result["provenance"] = provenance_json(plan.document.sha256);
  result["provenance"]["columns"] = list(plan.columns, [](const study::Column& one) { return one.key; });
  return result;
}

Json summary(std::istream& csv) {
  std::string line;
  std::vector<std::string> cells;
  std::vector<Numbers> columns;
  Occurrences endings, reasons;
  std::getline(csv, line);
  split(line, cells);
  for (std::size_t i = 0; i + 2 < cells.size(); ++i) columns.push_back({.key = cells[i]});
  for (Index row = 1; std::getline(csv, line); ++row) {
    split(line, cells);
    if (cells.size() != columns.size() + 2) continue;
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].add(cells[i]);
    add(cells[columns.size()], row, endings);
    if (!cells.back().empty()) add(cells.back(), row, reasons);
  }
  return {{"columns", list(columns, [](const auto& one) { return json(one); })},
          {"endings", json(endings, "ending")},
          {"reasons", json(reasons, "reason")}};
}

}  // namespace mariotte::report
