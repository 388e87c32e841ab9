#include "mariotte/flow/taylor/taylor_lanes.hpp"

namespace mariotte::flow::taylor {

std::unique_ptr<Expansion> make_expansion(std::size_t size) {
#ifdef MARIOTTE_AVX2
  const bool is_halved = __builtin_cpu_is("amdfam19h");  // Zen 4 takes registers of eight in two halves
  if (__builtin_cpu_supports("avx512vbmi") && !is_halved) return make_avx512_expansion(size);
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return make_avx2_expansion(size);
#endif
  return make_baseline_expansion(size);
}

}  // namespace mariotte::flow::taylor
