// What the series of contacts need whose force is a function of a width. Included by one source file per
// instruction set, which names the namespace they live in.
#pragma once
#include <array>

#include "mariotte/flow/taylor/row_fields.hpp"
#include "mariotte/flow/taylor/taylor_lanes.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

template <int N>
using WidthStart = std::array<LaneVector<N>, WidthField<Pace::plain>::states>;
template <int N>
using WidthNumbers = std::array<LaneVector<N>, WidthField<Pace::plain>::parameters>;

/// The states of a row, and u.
template <int N>
WidthStart<N> width_states(const std::array<LaneVector<N>, RowQuantities::states>& row,
                           const LaneVector<N>& u) {
  WidthStart<N> start;
  for (int i = 0; i < RowQuantities::states; ++i) start[i] = row[i];
  start[WidthQuantities::width] = u;
  return start;
}

/// The numbers of the branches of lanes, and 1/u.
template <int N>
struct Branches {
  WidthNumbers<N> parameter;
  LaneVector<N> weight;
};

/// Of lanes `first` and on. One without force has φ = 1.
template <int N>
Branches<N> width_numbers(const Lanes& lanes, int first) {
  using Q = WidthQuantities;
  Branches<N> made;
  auto& p = made.parameter;
  for (auto& one : p) one = LaneVector<N>(0.0);
  made.weight = LaneVector<N>(0.0);
  for (int lane = 0; lane < N * width; ++lane) {
    const int i = lane / width, k = lane % width;
    const auto* branch = first + lane < lanes.count ? lanes.branch[first + lane] : nullptr;
    p[Q::pull].part[i][k] = branch ? branch->curve.s : -1;
    if (!branch) continue;
    made.weight.part[i][k] = 1 / lanes.width[first + lane];
    p[Q::steepness].part[i][k] = 4 / branch->curve.radius;
    p[Q::push0].part[i][k] = branch->push[0];
    p[Q::push1].part[i][k] = branch->push[1];
    p[Q::push3].part[i][k] = branch->push[3];
    p[Q::push4].part[i][k] = branch->push[4];
    p[Q::push6].part[i][k] = branch->push[6];
    p[Q::loss].part[i][k] = branch->damping;
  }
  return made;
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
