#include "mariotte/model/microbody/microbody.hpp"

#include <cmath>
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::model {
namespace {

/// Height of the lowest point of tip i over the mass centre.
double underside(const Microbody& body, std::size_t tip) {
  const auto& one = body.body.tips[tip];
  return rotate(body.attitude, one.centre).e1 - one.radius;
}

bool is_finite(const Vector3& v) {
  return std::isfinite(v.e1) && std::isfinite(v.e2) && std::isfinite(v.e3);
}

void validate(const contact::BrachDunn& law) {
  if (!(law.stiffness > 0) || !std::isfinite(law.stiffness))
    throw InvalidParameter("stiffness must be positive and finite");
  for (const double value : {law.adhesion, law.damping_hertz, law.damping_adhesion})
    if (!(value >= 0) || !std::isfinite(value))
      throw InvalidParameter("adhesion and damping must be finite and not negative");
}

}  // namespace

double start_height(const Microbody& body) {
  return -underside(body, 0);
}

double tip_velocity(const Microbody& body, std::size_t tip) {
  return body.velocity.e1 + cross(body.spin, rotate(body.attitude, body.body.tips[tip].centre)).e1;
}

std::optional<std::size_t> tip_below_plane(const Microbody& body) {
  for (std::size_t i = 1; i < body.body.tips.size(); ++i) {
    const double rounding = 8 * epsilon * (norm(body.body.tips[i].centre) + norm(body.body.tips[0].centre));
    if (underside(body, i) < underside(body, 0) - rounding) return i;
  }
  return std::nullopt;
}

void validate(const Microbody& body) {
  validate(body.body);
  if (body.law.size() != body.body.tips.size()) throw InvalidParameter("a body needs one law per tip");
  for (const auto& law : body.law) validate(law);
  if (!(body.friction.coefficient >= 0 && body.friction.coefficient <= contact::most_friction))
    throw InvalidParameter("friction must be between 0 and 1e9, beyond which nothing slips");
  if (!is_finite(body.velocity) || !is_finite(body.spin) || !std::isfinite(body.gravity))
    throw InvalidParameter("velocity, spin and gravity must be finite");
  if (body.impacts < 1) throw InvalidParameter("there must be at least one impact");
  if (const auto tip = tip_below_plane(body))
    throw InvalidParameter("tip " + std::to_string(*tip + 1) + " starts below the plane");
  if (!(body.velocity.e1 < 0)) throw InvalidParameter("the body does not approach the plane");
  if (!(tip_velocity(body, 0) < 0)) throw InvalidParameter("the spin carries the first tip off the plane");
}

}  // namespace mariotte::model
