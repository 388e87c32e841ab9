#include "mariotte/flow/short_row/short_row_lanes.hpp"

#include "mariotte/flow/lanes/lane_precision.hpp"

namespace mariotte::flow {

void ShortRows::follow(std::span<ShortRow> rows, double accuracy) {
  const auto precision = lane_precision(accuracy, short_row_orders, share_in_rows);
  int below = 0;
  for (std::size_t i = 0; i < std::size(sizes); below = sizes[i++]) {
    std::size_t count = 0;
    for (auto& row : rows)
      if (row.stage == RowStage::pushes && row.contacts > below && row.contacts <= sizes[i])
        selected_[count++] = &row;
    if (count == 0) continue;
    if (!lanes_[i]) lanes_[i] = make_short_row_lanes(sizes[i]);
    lanes_[i]->follow({selected_, count}, precision);
  }
}

}  // namespace mariotte::flow
