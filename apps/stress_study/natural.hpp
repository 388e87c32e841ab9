// Natural sizes of a contact: what its depth and time are compared with.
#pragma once
#include <cmath>

#include "mariotte/contact/law.hpp"

namespace mariotte::stress_study {

/// Depth of a contact that is struck at a speed by a body of mass 1/`mobility`; 0 if nothing moves.
inline double natural_depth(const contact::Law& law, double mobility, double speed) {
  if (!(mobility > 0)) return 0;
  if (const auto* power = contact::power_law(law))
    return std::pow((power->exponent + 1) * speed * (speed / power->stiffness) / (2 * mobility),
                    1 / (power->exponent + 1));
  return std::get<contact::SharedLaw>(law)->natural_indentation(speed * speed / (2 * mobility));
}

/// The time in which it goes so deep.
inline double natural_time(const contact::Law& law, double mobility, double speed) {
  return natural_depth(law, mobility, speed) / speed;
}

}  // namespace mariotte::stress_study
