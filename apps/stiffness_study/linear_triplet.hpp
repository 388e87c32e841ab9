// Three equal balls with linear contacts in closed form [Acary 2003, Appendix B, corrected].
#pragma once
#include <vector>

namespace mariotte::stiffness_study {

/// Final velocities for k = m = v₁ = 1, v₂ = v₃ = 0 and stiffness ratio κ ≥ 1, in extended precision. Each
/// contact closes once: the overlaps are sums of two sines until the first of them opens, then the other two
/// balls part like a pair.
std::vector<double> linear_triplet(double ratio);

}  // namespace mariotte::stiffness_study
