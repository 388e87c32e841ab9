// Short rows side by side; compiled once per instruction set.
#pragma once
#include "mariotte/flow/lanes/side_by_side.hpp"
#include "mariotte/flow/short_row/short_row_lanes.hpp"
#include "mariotte/flow/short_row/short_row_step.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

template <int N>
class ShortRowSeries final : public ShortRowLanes {
 public:
  void follow(std::span<ShortRow* const> rows, const Precision& precision) override {
    lanes_.follow(rows, precision,
                  [&](int lane, ShortRow& row, int steps) { return look(lane, row, steps); });
  }

 private:
  Look look(int lane, ShortRow& row, int steps) const {
    const auto& step = lanes_.step();
    const int j = step.change(lane);
    step.put(lane, row);
    row.series_steps = steps;
    if (lanes_.is_over(steps) || has_faded(row))
      row.stage = RowStage::leaves;
    else if (j < 0)
      return Look::goes_on;
    else
      step.wakes(lane) ? wake(row, j) : flow::change(row, j);
    return row.stage == RowStage::pushes ? Look::changed : Look::ended;
  }

  SideBySide<ShortRowStep<N>> lanes_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::flow::ShortRowLanes> mariotte::flow::MARIOTTE_INSTRUCTION_SET::make_short_row_lanes(
    int contacts) {
  using namespace taylor::MARIOTTE_INSTRUCTION_SET;
  if (contacts <= 4) return std::make_unique<ShortRowSeries<4>>();
  if (contacts <= 6) return std::make_unique<ShortRowSeries<6>>();
  return std::make_unique<ShortRowSeries<8>>();
}
