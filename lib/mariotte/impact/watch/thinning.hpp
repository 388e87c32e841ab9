// Fewer rows of a trace: a picture misses those least that are nearest to the line between their neighbours.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::impact {

/// Of traces of bodies and microbodies.
inline constexpr std::size_t most_rows = 20000;

/// How far rows are from the line between their neighbours, relative to the largest of their column, or to a
/// thousandth of the largest of the table: less is rounding, or too faint to be seen.
class Bends {
 public:
  explicit Bends(const std::vector<double>& time) : time_(time), bend_(time.size(), 0) {}

  /// A table of one kind of numbers, at(row, column).
  template <class At>
  void add(std::size_t columns, At&& at) {
    constexpr double faint = 1e-3;
    most_.assign(columns, 0);
    for (std::size_t i = 0; i < time_.size(); ++i)
      for (std::size_t c = 0; c < columns; ++c) most_[c] = std::max(most_[c], std::abs(at(i, c)));
    double largest = 0;
    for (const double one : most_) largest = std::max(largest, one);
    if (!(largest > 0)) return;
    for (std::size_t i = 1; i + 1 < time_.size(); i += 2)
      for (std::size_t c = 0; c < columns; ++c)
        bend_[i] = std::max(bend_[i], bend(at, i, c) / std::max(most_[c], faint * largest));
  }

  /// All rows but a quarter, the straightest. No two neighbours go at once.
  std::vector<char> rows_to_keep() const {
    std::vector<double> sorted;
    for (std::size_t i = 1; i + 1 < bend_.size(); i += 2) sorted.push_back(bend_[i]);
    const auto middle = sorted.begin() + std::ssize(sorted) / 2;
    std::nth_element(sorted.begin(), middle, sorted.end());
    std::vector<char> keep(bend_.size(), true);
    for (std::size_t i = 1; i + 1 < bend_.size(); i += 2) keep[i] = bend_[i] > *middle;
    return keep;
  }

 private:
  double bend(auto&& at, std::size_t i, std::size_t c) const {
    const double whole = time_[i + 1] - time_[i - 1],
                 share = whole > 0 ? (time_[i] - time_[i - 1]) / whole : 0.5;
    return std::abs(at(i, c) - std::lerp(at(i - 1, c), at(i + 1, c), share));
  }

  const std::vector<double>& time_;
  std::vector<double> bend_, most_;  ///< of rows, of columns
};

/// Of each column the rows to keep.
template <class... Columns>
void keep_rows(const std::vector<char>& keep, Columns&... columns) {
  const auto shrink = [&](auto& column) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < column.size(); ++i)
      if (keep[i] && kept++ < i) column[kept - 1] = std::move(column[i]);
    column.resize(kept);
  };
  (shrink(columns), ...);
}

/// How many rows are no later than an instant: a flow that gave up may have gone on. `time` tells that of a
/// row.
template <class Rows, class Time = std::identity>
std::size_t rows_until(double instant, const Rows& rows, Time time = {}) {
  const double latest = instant + 8 * epsilon * std::abs(instant);
  return std::ranges::upper_bound(rows, latest, {}, time) - rows.begin();
}

template <class... Columns>
void cut_rows(std::size_t count, Columns&... columns) {
  (columns.resize(count), ...);
}

}  // namespace mariotte::impact
