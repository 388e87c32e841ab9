// What the contacts of a long row do to each other, in many blocks of registers. Included by one source file
// per instruction set, which names the namespace they live in.
#pragma once
#include <vector>

#include "mariotte/flow/taylor/taylor_lanes.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// The impulses of one order, of blocks of N registers.
template <int N>
class RowPushes {
 public:
  void resize(std::size_t blocks) { impulse_.assign(blocks + 2, LaneVector<N>(0.0)); }
  /// Only contacts that push do.
  void set(std::size_t block, const Lanes& lanes, const LaneVector<N>& impulse) {
    impulse_[block + 1] = load<N>(lanes.active + block * size) * impulse;
  }
  /// What they do to δ̇ of a block.
  LaneVector<N> bend(std::size_t block, const Lanes& lanes) const {
    const auto left = load<N>(lanes.left + block * size), right = load<N>(lanes.right + block * size);
    const auto* impulse = reinterpret_cast<const double*>(&impulse_[block + 1]);
    return left * load_loose<N>(impulse - 1) + right * load_loose<N>(impulse + 1) -
           (left + right) * impulse_[block + 1];
  }

 private:
  static constexpr std::size_t size = N * width;
  std::vector<LaneVector<N>> impulse_;  ///< between two blocks of zeros
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
