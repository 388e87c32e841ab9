// Slopes of a state: one column per parameter.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::impact {

/// ∂x/∂p of n components by P parameters, column after column.
struct SlopeMatrix {
  Index rows = 0, columns = 0;
  std::vector<double> values;

  SlopeMatrix() = default;
  SlopeMatrix(Index n, Index count) : rows(n), columns(count), values(n * count, 0.0) {}

  double& operator()(Index row, Index column) { return values[column * rows + row]; }
  double operator()(Index row, Index column) const { return values[column * rows + row]; }
  std::span<double> column(Index c) {
    return std::span(values).subspan(c * rows, static_cast<std::size_t>(rows));
  }
  std::span<const double> column(Index c) const {
    return std::span(values).subspan(c * rows, static_cast<std::size_t>(rows));
  }
  /// Another size; what it holds is zero then.
  void reset(Index n, Index count) {
    rows = n;
    columns = count;
    values.assign(n * count, 0.0);
  }
  void clear() { std::fill(values.begin(), values.end(), 0.0); }
};

/// The same with more rows, which are zero.
inline SlopeMatrix with_rows(const SlopeMatrix& slopes, Index rows) {
  if (rows == slopes.rows) return slopes;
  SlopeMatrix result(rows, slopes.columns);
  for (Index c = 0; c < slopes.columns; ++c)
    std::copy_n(slopes.column(c).begin(), slopes.rows, result.column(c).begin());
  return result;
}

}  // namespace mariotte::impact
