// How the damping c δ^q δ̇ of a contact with the elastic force k δⁿ grows with δ.
#pragma once

namespace mariotte {

/// As the slope of that force, as the force itself, or as the root of the slope, with which a pair has one
/// restitution for all speeds.
enum class Damping : signed char { as_slope, as_force, as_root };

/// q for an n.
inline double damping_exponent(Damping grows, double exponent) {
  if (grows == Damping::as_force) return exponent;
  return grows == Damping::as_root ? 0.5 * (exponent - 1) : exponent - 1;
}

}  // namespace mariotte
