#include "mariotte/report/json/column_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/csv/sweep_csv.hpp"
#include "mariotte/report/json/json_parts.hpp"

namespace mariotte::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Between the two sorted numbers that stand at a share of the way.
double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return none;
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

double deviation(const std::vector<double>& values, double mean) {
  if (values.size() < 2) return none;
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

Statistics statistics_of(const std::string& key, const std::string& unit, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto count = values.size();
  const double mean =
      count == 0 ? none : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(count);
  return {.key = key,
          .unit = unit,
          .numbers = count,
          .least = quantile(values, 0),
          .greatest = quantile(values, 1),
          .mean = mean,
          .deviation = deviation(values, mean),
          .q05 = quantile(values, 0.05),
          .q25 = quantile(values, 0.25),
          .q50 = quantile(values, 0.5),
          .q75 = quantile(values, 0.75),
          .q95 = quantile(values, 0.95)};
}

Json or_null(double value) {
  return std::isnan(value) ? Json(nullptr) : Json(value);
}

}  // namespace

ColumnStatistics::ColumnStatistics(std::string_view header) {
  split(header, keys_);
  keys_.resize(keys_.size() - std::min<std::size_t>(keys_.size(), 2));
  for (auto& key : keys_) {
    units_.push_back(unit_of_column(key));
    key = key_of_column(key);
  }
  numbers_.resize(keys_.size());
}

void ColumnStatistics::add(std::string_view rows) {
  while (!rows.empty()) {
    const auto end = std::min(rows.find('\n'), rows.size());
    split(rows.substr(0, end), cells_);
    rows.remove_prefix(std::min(end + 1, rows.size()));
    if (cells_.size() != keys_.size() + 2) continue;
    for (std::size_t i = 0; i < keys_.size(); ++i)
      if (const double value = number(cells_[i]); !std::isnan(value)) numbers_[i].push_back(value);
  }
}

std::vector<Statistics> ColumnStatistics::statistics() const {
  std::vector<Statistics> list;
  for (std::size_t i = 0; i < keys_.size(); ++i)
    list.push_back(statistics_of(keys_[i], units_[i], numbers_[i]));
  return list;
}

Json ColumnStatistics::json() const {
  return list(statistics(), [](const Statistics& one) {
    return Json{{"key", one.key},
                {"unit", one.unit},
                {"numbers", one.numbers},
                {"least", or_null(one.least)},
                {"greatest", or_null(one.greatest)},
                {"mean", or_null(one.mean)},
                {"deviation", or_null(one.deviation)},
                {"q05", or_null(one.q05)},
                {"q25", or_null(one.q25)},
                {"q50", or_null(one.q50)},
                {"q75", or_null(one.q75)},
                {"q95", or_null(one.q95)}};
  });
}

}  // namespace mariotte::report
