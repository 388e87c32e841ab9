#include "mariotte/flow/sphere/sphere_lanes.hpp"

namespace mariotte::flow {

std::unique_ptr<SphereLanes> make_sphere_lanes() {
#ifdef MARIOTTE_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return make_avx2_sphere_lanes();
#endif
  return make_baseline_sphere_lanes();
}

}  // namespace mariotte::flow
