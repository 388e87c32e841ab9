// The series of a block of lanes in registers; compiled once per instruction set.
#pragma once
#include "mariotte/flow/cluster/lane_block.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

class LaneSeries final : public LaneBlock {
 public:
  LaneSeries() { rows_ = reinterpret_cast<double*>(&series_[0]); }

  void begin(const double* start, const double* parameters) override {
    series_.begin(taken<ClusterField::states>(start), taken<ClusterField::parameters>(parameters));
  }
  void stage(int k) override { series_.stage(k); }
  void finish(int k) override { series_.finish(k); }

 private:
  using Number = LaneVector<lanes / width>;

  template <std::size_t count>
  static std::array<Number, count> taken(const double* from) {
    std::array<Number, count> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers[i] = load<Number::parts>(from + i * lanes);
    return numbers;
  }

  series::Series<ClusterField, most_order, Number> series_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::flow::LaneBlock> mariotte::flow::MARIOTTE_INSTRUCTION_SET::make_lane_block() {
  return std::unique_ptr<LaneBlock>(new taylor::MARIOTTE_INSTRUCTION_SET::LaneSeries);
}
