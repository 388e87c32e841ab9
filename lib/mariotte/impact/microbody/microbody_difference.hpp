// By how much two runs of a body differ.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/model/microbody/microbody.hpp"

namespace mariotte::impact {

/// Of a difference of final velocities and spins: the larger of the former and of the latter times the reach
/// of the first tip, relative to the largest incident speed; infinite if one is not a number.
inline double difference(const model::Microbody& body, const Vector3& velocity, const Vector3& spin) {
  const auto& tip = body.body.tips[0];
  const Vector3 turning = cross(body.spin, rotate(body.attitude, tip.centre));
  const double speed = std::max(norm(body.velocity), norm(body.velocity + turning));
  const double apart = std::max(norm(velocity), (norm(tip.centre) + tip.radius) * norm(spin)) / speed;
  return std::isnan(norm(velocity) + norm(spin)) ? infinity : apart;
}

}  // namespace mariotte::impact
