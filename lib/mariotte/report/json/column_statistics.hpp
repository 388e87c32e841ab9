// What the numbers of a sweep are like, column by column.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// Of one column; nan where there are too few numbers.
struct Statistics {
  std::string key, unit;  ///< the unit of the header; "1" without one
  std::size_t numbers = 0;
  double least, greatest, mean;
  double deviation;                ///< of a sample: Σ(x − mean)²/(n − 1), its root
  double q05, q25, q50, q75, q95;  ///< quantiles, linear between the sorted numbers
};

/// Takes the rows of a sweep as text, keeps their numbers.
class ColumnStatistics {
 public:
  /// The first line of the CSV; the last two columns are `ending` and `reason`.
  explicit ColumnStatistics(std::string_view header);
  /// Any number of lines; those that are no rows are left out.
  void add(std::string_view rows);

  std::size_t columns() const { return keys_.size(); }
  std::vector<Statistics> statistics() const;
  /// A list of objects with the members of Statistics.
  Json json() const;

 private:
  std::vector<std::string> keys_, units_;
  std::vector<std::vector<double>> numbers_;
  std::vector<std::string> cells_;
};

}  // namespace mariotte::report
