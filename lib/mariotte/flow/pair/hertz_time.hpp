// How long a Hertz contact takes: T(y) = ∫₀^y (1−u²)^{−3/5} du.
#pragma once
#include <numbers>

#include "mariotte/flow/pair/hypergeometric.hpp"

namespace mariotte::flow {

/// T(y) = y ₂F₁(1/2, 3/5; 3/2; y²), and T(1) − T(y) = (5/4) z^{2/5} ₂F₁(2/5, 1/2; 7/5; z) with z = 1 − y²;
/// each up to y² = z = 1/2.
inline constexpr HalfHypergeometric from_middle(0.5, 0.6, 1.5), from_end(0.4, 0.5, 1.4);
inline constexpr double hertz_middle = 0.5 * std::numbers::sqrt2;  ///< y where the two forms meet
inline constexpr double hertz_half_depth = 0.75785828325519904;    ///< z^{2/5} there
inline constexpr double full_hertz_time =                          ///< T(1)
    hertz_middle * from_middle(0.5) + 1.25 * hertz_half_depth * from_end(0.5);

}  // namespace mariotte::flow
