// The series for any processor.
#define MARIOTTE_INSTRUCTION_SET baseline
#define MARIOTTE_VECTOR_BYTES 16
#include "mariotte/flow/cluster/lane_series.hpp"

namespace mariotte::flow {

std::unique_ptr<LaneBlock> make_baseline_lane_block() {
  return std::unique_ptr<LaneBlock>(new taylor::baseline::LaneSeries);
}

}  // namespace mariotte::flow
