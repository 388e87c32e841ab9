#include "mariotte/flow/balls/ball_expansions.hpp"

namespace mariotte::flow {

std::unique_ptr<BallExpansions> make_ball_expansions() {
#ifdef MARIOTTE_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return make_avx2_ball_expansions();
#endif
  return make_baseline_ball_expansions();
}

}  // namespace mariotte::flow
