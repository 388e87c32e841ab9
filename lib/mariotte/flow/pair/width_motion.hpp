// Two bodies in one closed contact whose undamped force is a polynomial in the root u of a contact radius.
//
// With W(u) = ∫ f dδ the energy gives the rate, δ̇² = P(u) = δ̇₀² − (2/m*) (W(u) − W(u₀)). Where it turns, at
// u*, P = (u* − u) Q(u), and with u = u* − y²
//
//     δ̇ = −y √Q,    dt = 2 φ(u)/√Q dy,    φ = dδ/du,
//
// smooth from far before the turn (y < 0) to where the contact lets go. Times are integrals by Gauss's rule.
#pragma once
#include <array>

#include "mariotte/core/width_branch.hpp"
#include "mariotte/flow/pair/indentation.hpp"

namespace mariotte::flow {

/// δ(t) of such a pair.
class WidthMotion {
 public:
  WidthMotion(const WidthBranch& branch, double reduced_mass, const Indentation& start);
  /// Where it lets go; after an infinite time if it is held.
  Reached opening() const;
  double turn() const { return y_start_ < 0 ? time(y_start_, 0) : 0; }
  Reached reach(double depth) const;
  Reached recede(double speed) const;
  Indentation at(double time) const;
  /// Nothing else is near.
  double fall(const ConcaveGap&) const { return infinity; }

 private:
  static constexpr int degree = 10;  ///< of W
  double width(double y) const { return top_ - y * y; }
  double speed_over_y(double y) const;  ///< √Q
  double pace(double y) const { return 2 * curve_.slope(width(y)) / speed_over_y(y); }
  double time(double from, double to) const;
  Indentation there(double y) const;
  void find_top(const std::array<double, degree + 1>& square, double width);

  WidthCurve curve_;
  std::array<double, degree> quotient_ = {};  ///< Q
  double top_ = 0;                            ///< u*
  double y_start_ = 0, y_end_ = 0;            ///< y_end: where it lets go
};

}  // namespace mariotte::flow
