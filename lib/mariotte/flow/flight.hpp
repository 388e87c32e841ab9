// Free flight of a symmetric body in closed form: the mass centre on a parabola, the axis precessing about
// the constant angular momentum, the body turning about its axis.
#pragma once
#include "mariotte/core/quaternion.hpp"
#include "mariotte/flow/tip_phase.hpp"

namespace mariotte::flow {

/// Height of a tip in flight: start + rate t − g t²/2 + swing (cos(Ω t + φ) − cos φ).
struct TipHeight {
  double start, rate, gravity;
  double swing = 0, turn = 0, phase = 0;  ///< turn = Ω ≥ 0

  double at(double t) const;
  double slope(double t) const;
};

/// First t > 0 at which the height falls through zero; infinite if it never does. Between its inflections the
/// slope is monotone, between the zeros of the slope the height is: no root is missed. A tip that starts at
/// zero and rises does not count, nor, one that falls from there, its start.
double first_touch(const TipHeight& height);

/// Attitude after time t, from angular momentum h in space axes.
Quaternion flown(const Quaternion& attitude, const Vector3& momentum, const SymmetricBody& body, double t);

}  // namespace mariotte::flow
