// The series in registers of four, for processors with AVX2 and FMA.
#define MARIOTTE_INSTRUCTION_SET avx2
#define MARIOTTE_VECTOR_BYTES 32
#include "mariotte/flow/cluster/lane_series.hpp"

namespace mariotte::flow {

std::unique_ptr<LaneBlock> make_avx2_lane_block() {
  return std::unique_ptr<LaneBlock>(new taylor::avx2::LaneSeries);
}

}  // namespace mariotte::flow
