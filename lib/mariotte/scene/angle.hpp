// Angles that look like degrees.
#pragma once
#include <cmath>
#include <numbers>
#include <string>

namespace mariotte::scene {

/// Of an angle [rad] of more than a turn, which was meant in degrees; else empty.
inline std::string hint_at_radians(double angle) {
  return std::abs(angle) > 2 * std::numbers::pi ? " (a bare number is in radians; \"42 deg\" is in degrees)"
                                                : "";
}

}  // namespace mariotte::scene
