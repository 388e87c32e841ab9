// Three equal balls with linear contacts, the first striking two that touch at rest, in closed form [Acary
// 2003, Appendix B, corrected].
#pragma once
#include <array>

namespace mariotte::impact {

/// k₂ = κ k₁; all four positive and finite.
struct LinearTriplet {
  double mass = 1;       ///< m of every ball [kg]
  double stiffness = 1;  ///< k₁ [N/m]
  double ratio = 1;      ///< κ
  double speed = 1;      ///< v₁ [m/s]
};

/// The contact that opens first [Acary 2003, Prop. 4.1].
enum class FirstToOpen { contact_1, contact_2, both };

/// What the three balls do.
struct LinearTripletImpact {
  std::array<double, 3> velocity;  ///< [m/s]
  std::array<double, 2> impulse;   ///< [N s]
  std::array<double, 2> opening;   ///< instants at which the contacts open; both close at 0 [s]
  double icr;                      ///< α = p₁/p₂, 1 ≤ α ≤ 2
  FirstToOpen first;
};

/// The outcome, to the rounding of its inputs. Each contact closes once: the overlaps are sums of two sines
/// until the first of them opens, then the other two balls part like a pair. Throws InvalidParameter.
LinearTripletImpact linear_triplet(const LinearTriplet& triplet);

/// ω₂/ω₁ of the two natural frequencies with both contacts closed, ≥ √3.
double frequency_ratio(double stiffness_ratio);

/// The stiffness ratio κ_j ≥ 1 at which ω₂/ω₁ is the integer j ≥ 2: both contacts open at π/ω₁.
/// Throws InvalidParameter.
double integer_stiffness_ratio(int j);

/// Final velocities / v₁ at κ_j, j ≥ 2: (−1/3, 2/3, 2/3) for every odd j. Throws InvalidParameter.
std::array<double, 3> integer_velocities(int j);

}  // namespace mariotte::impact
