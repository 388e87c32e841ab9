#include "mariotte/model/contacts/scaled_law.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::model {

contact::Law scaled(const contact::Law& law, const Scale& scale, const contact::Law& reference) {
  const double n = contact::exponent(law);
  const double stiffness = n == contact::exponent(reference)
                               ? contact::stiffness(law) / contact::stiffness(reference)
                               : contact::stiffness(law) * std::pow(scale.length, n + 1) / scale.energy();
  if (std::holds_alternative<contact::Linear>(law)) return contact::Linear{stiffness};
  if (std::holds_alternative<contact::Hertz>(law)) return contact::Hertz{stiffness};
  const double damping = contact::damping(law) * std::pow(scale.length, n) / scale.momentum();
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = n};
}

double natural_length(const contact::Law& law, double mass, double speed) {
  return natural_root(mass * speed * speed / contact::stiffness(law), contact::exponent(law));
}

double slow_share(double accuracy) {
  return std::max(0.1 * accuracy, 8 * epsilon);
}

}  // namespace mariotte::model
