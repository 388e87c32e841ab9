// What the series of contacts need whose force is a curve of cubic segments. Included by one source file per
// instruction set, which names the namespace they live in.
#pragma once
#include <array>

#include "mariotte/flow/taylor/row_fields.hpp"
#include "mariotte/flow/taylor/taylor_lanes.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// The numbers of powers, and those of the segments of lanes `first` and on; zero for one without.
template <int N>
std::array<LaneVector<N>, CurveQuantities::curve_parameters> curve_numbers(
    const Lanes& lanes, int first, const std::array<LaneVector<N>, RowQuantities::parameters>& powers) {
  using Q = CurveQuantities;
  std::array<LaneVector<N>, Q::curve_parameters> made;
  for (auto& one : made) one = LaneVector<N>(0.0);
  for (int i = 0; i < Q::parameters; ++i) made[i] = powers[i];
  for (int lane = 0; lane < N * width && first + lane < lanes.count; ++lane) {
    const auto* segment = lanes.segment[first + lane];
    if (!segment) continue;
    const int i = lane / width, k = lane % width;
    made[Q::from].part[i][k] = segment->from;
    for (int n = 0; n < 4; ++n) made[Q::push0 + n].part[i][k] = segment->a[n];
  }
  return made;
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
