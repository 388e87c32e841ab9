// Three balls of unit mass that touch, with contacts f = max(0, k δ^{3/2} + c δ^{1/2} δ̇): an impact in
// quadruple precision, by a method that shares nothing with the library.
//
//   each contact is   open      g ≥ 0, no force
//                     carrying  δ > 0 and k δ + c δ̇ > 0
//                     slack     δ > 0, k δ + c δ̇ ≤ 0, no force
//   carrying contacts are followed in x = √δ and a clock in which everything is analytic, through onset and
//   separation:       one: dt = x ds      two: dt = x₁x₂/(x₁ + x₂) ds      none: straight lines
//   the first instants, before which both x are zero: power series in t^{1/4}
#pragma once
#include <array>

#include "real.hpp"

namespace mariotte::reference {

struct Triplet {
  std::array<Real, 2> stiffness;
  Real damping;
  std::array<Real, 3> velocity;
};

struct Outcome {
  std::array<Real, 3> velocity;
  Real end;                    ///< time of the last separation
  std::array<int, 2> periods;  ///< how often each contact begins to carry force
};

Outcome impact(const Triplet& triplet);

}  // namespace mariotte::reference
