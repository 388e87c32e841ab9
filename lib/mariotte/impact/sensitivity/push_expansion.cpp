#include "mariotte/impact/sensitivity/push_expansion.hpp"

#include <algorithm>

namespace mariotte::impact {

std::unique_ptr<PushExpansion> make_push_expansion() {
#ifdef MARIOTTE_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return make_avx2_push_expansion();
#endif
  return make_baseline_push_expansion();
}

bool PushExpansion::knows(const contact::PowerLaw& law, const ContactSlope& slope) {
  const bool has_tilts = law.exponent == 1.5 && law.damping != 0;
  const auto is_known = [&](const LawSlope& one) { return has_tilts || one.power.exponent == 0; };
  return (law.exponent == 1 || law.exponent == 1.5) && slope.direction.empty() &&
         std::all_of(slope.law.begin(), slope.law.end(), is_known);
}

}  // namespace mariotte::impact
