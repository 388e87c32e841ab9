// Slopes of a cubic through points that overshoots none of them.
#pragma once
#include <span>
#include <vector>

namespace mariotte {

/// One slope per point (x, y), two points or more with growing x: weighted harmonic means where the secants
/// beside a point have one sign, and 0 else; at the ends the slope of a parabola, as long as that stays
/// monotone [Fritsch & Butland 1984, SIAM J Sci Stat Comput 5:300].
std::vector<double> monotone_slopes(std::span<const double> x, std::span<const double> y);

}  // namespace mariotte
