// Series of eight contacts side by side, order by order. Code compiled for different instruction sets shares
// nothing but this layout.
#pragma once
#include <memory>

#include "mariotte/flow/cluster/cluster_field.hpp"
#include "mariotte/flow/instruction_set.hpp"

namespace mariotte::flow {

/// Numbers stand in rows of one per lane.
class LaneBlock {
 public:
  static constexpr int lanes = 8, most_order = 22, stride = (most_order + 2) * lanes;
  virtual ~LaneBlock() = default;
  /// Order 0, and order 1 of what is not given. Rows begin at boundaries of registers.
  virtual void begin(const double* start, const double* parameters) = 0;
  /// Order k of all values and k + 1 of states, once what is given is known up to k.
  virtual void stage(int k) = 0;
  /// Order k of values that somebody looks at.
  virtual void finish(int k) = 0;
  /// Coefficient k of a row, for all lanes.
  double* at(int row, int k) { return rows_ + row * stride + k * lanes; }

 protected:
  double* rows_ = nullptr;
};

MARIOTTE_PER_INSTRUCTION_SET(std::unique_ptr<LaneBlock>, make_lane_block, (), ())

}  // namespace mariotte::flow
