// A microbody in units of order one, and what can move in it.
#pragma once
#include <vector>

#include "mariotte/core/scale.hpp"
#include "mariotte/flow/tip_phase.hpp"
#include "mariotte/model/microbody/microbody.hpp"

namespace mariotte::model {

/// The body divided by `scale`: lengths are of the order of the indentation, (m v²/√r K)^{2/5}, not of the
/// body. The state holds gaps as such, so that nothing is lost between the two.
struct DimensionlessMicrobody {
  Scale scale;
  RigidBody body;  ///< with those tips only that take part
  std::vector<contact::BrachDunn> law;
  contact::Coulomb friction;
  Quaternion attitude;
  Vector3 velocity, momentum;  ///< momentum: angular, space axes
  std::vector<double> gap;     ///< of each tip at the start; 0 for the first
  double gravity = 0;
  Lever lever = Lever::radius;
  Index impacts = 1;
  AfterCapture after_capture = AfterCapture::stop;

  double speed = 1;  ///< largest incident speed: what the accuracy is relative to
  double time = 1;   ///< natural time of a contact
  bool symmetric = true;
  flow::TipPhase::Motion motion = flow::TipPhase::Motion::spatial;
  Vector3 tangent, axis;  ///< of planar motion

  std::size_t tips() const { return body.tips.size(); }
};

/// Converts a validated body. A motion that starts along the normal, or in a plane, to rounding stays so, and
/// is made so exactly. Throws Unrepresentable.
DimensionlessMicrobody dimensionless(const Microbody& body);

/// A validated body with other numbers than the one `base` was made from, in the units of `base`. It may move
/// in any way: what starts in a plane is not taken to stay there.
DimensionlessMicrobody restated(const Microbody& body, const DimensionlessMicrobody& base);

/// A body that may turn about a tip that adhesion holds. A sphere, or one that moves along the normal only,
/// comes to rest altogether.
bool can_swing(const DimensionlessMicrobody& body);

/// The accuracy that steps need. The well of adhesion makes a slow body much faster, and its own speed is
/// what is left of that: it keeps the accuracy asked for if the larger speed is as much more accurate. No
/// finer than rounding of the larger speed.
double reachable_accuracy(const DimensionlessMicrobody& body, double asked);

}  // namespace mariotte::model
