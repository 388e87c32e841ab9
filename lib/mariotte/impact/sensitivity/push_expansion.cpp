#include "mariotte/impact/sensitivity/push_expansion.hpp"

#include <algorithm>

namespace mariotte::impact {

bool PushExpansion::knows(const contact::PowerLaw& law, const ContactSlope& slope) {
  const bool has_tilts = law.exponent == 1.5 && law.damping != 0;
  const auto is_known = [&](const LawSlope& one) { return has_tilts || one.power.exponent == 0; };
  return (law.exponent == 1 || law.exponent == 1.5) && slope.direction.empty() &&
         std::all_of(slope.law.begin(), slope.law.end(), is_known);
}

}  // namespace mariotte::impact
