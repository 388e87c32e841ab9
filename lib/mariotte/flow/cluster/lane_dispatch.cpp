#include "mariotte/flow/cluster/lane_block.hpp"

namespace mariotte::flow {

std::unique_ptr<LaneBlock> make_lane_block() {
#ifdef MARIOTTE_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return make_avx2_lane_block();
#endif
  return make_baseline_lane_block();
}

}  // namespace mariotte::flow
