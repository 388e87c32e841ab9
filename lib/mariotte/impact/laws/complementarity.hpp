// Linear complementarity problems of frictionless impacts: simultaneous contacts that may push or part, but
// not both.
#pragma once
#include <vector>

namespace mariotte::impact {

/// p with 0 ≤ p ⊥ W p + q ≥ 0, m values. W = G M⁻¹ Gᵀ (m², symmetric, not negative), q = G u of any u: then
/// p minimises the kinetic energy ½ |M^{1/2} u + M^{−1/2} Gᵀ p|² and always exists. W p + q is unique; p is
/// not where W is singular. By the active-set method of Lawson & Hanson for such least squares, which passes
/// from one set of pushing contacts to a better one; small dense problems, cost m³ per set. Throws Error if
/// rounding makes it return to the same sets.
std::vector<double> solve_complementarity(const std::vector<double>& w, const std::vector<double>& q);

}  // namespace mariotte::impact
