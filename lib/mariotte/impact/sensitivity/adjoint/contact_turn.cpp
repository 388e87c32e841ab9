#include "mariotte/impact/sensitivity/adjoint/contact_turn.hpp"

namespace mariotte::impact {

UntilEnd::UntilEnd() {
  for (int j = 0; j < stages; ++j)
    for (int i = 0; i < stages; ++i) weight[j][i] = gauss.weight[j] - gauss.integral[i][j];
}

TurnContact choose_turn() {
#ifdef MARIOTTE_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return turn_by_avx2;
#endif
  return turn_by_baseline;
}

}  // namespace mariotte::impact
