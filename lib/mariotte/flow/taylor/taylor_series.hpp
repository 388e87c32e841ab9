// The expansions of a row, in one block of registers, and of contacts linked in any way.
#pragma once
#include "mariotte/flow/taylor/linked_series.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

template <int N>
class RowSeries final : public Expansion {
 public:
  Outlook activate(Lanes& lanes, double near, bool onsets) const override {
    return MARIOTTE_INSTRUCTION_SET::activate<N>(lanes, 0, near, onsets);
  }
  void expand(const Lanes& lanes, int order, int clock) override {
    order_ = order;
    block_.start(lanes, order, clock, pace_start(lanes, clock));
    block_.with_series(
        [&](auto& series) { series.expand_states(block_.start_states(), block_.parameter_values(), order); });
  }
  void sizes(int first, double* size) const override {
    for (int k = first; k <= order_; ++k) size[k - first] = block_.motion().size_of(k);
  }
  void evaluate(double place, Values& values) const override {
    values.may_fall = values.is_deep = values.may_change = false;
    block_.motion().evaluate(place, values);
    values.time = block_.motion().time_at(place);
  }
  void sharpen(double place, Values& values) const override {
    values.may_fall = false;
    block_.motion().sharpen(place, values);
  }
  void coefficients(Quantity quantity, int lane, double* c) const override {
    block_.motion().coefficients(quantity, lane, c);
  }

 private:
  int order_ = 0;
  Block<N, Given::by_neighbours> block_;
};

/// Of a row.
inline constexpr int most_lanes = width == 2 ? baseline_row_limit : most_row_limit;

/// The series of lane_sizes[size] lanes, or of linked ones.
template <std::size_t Size = 0>
std::unique_ptr<Expansion> make_rows(std::size_t size) {
  if constexpr (Size < sizes_up_to(most_lanes))
    return size == Size ? std::unique_ptr<Expansion>(new RowSeries<(lane_sizes[Size] + width - 1) / width>)
                        : make_rows<Size + 1>(size);
  else
    return std::unique_ptr<Expansion>(new LinkedSeries);
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::flow::taylor::Expansion>
mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET::make_expansion(std::size_t size) {
  return make_rows(size);
}
