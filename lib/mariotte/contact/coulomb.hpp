// Dry friction on the magnitude of the normal force, pull included [Cheng 2002, eq. 6–7]: a sliding tip feels
// μ |F_n| against its slip, a sticking one at most as much in any direction.
#pragma once

namespace mariotte::contact {

/// The largest coefficient. Far beyond, rounding of the normal force alone would move what sticks.
inline constexpr double most_friction = 1e9;

/// Dry friction with one coefficient for slip and stick.
struct Coulomb {
  double coefficient = 0;  ///< μ ≥ 0
};

/// Largest friction at a normal force, μ |F_n| [N].
template <class T>
T limit(const Coulomb& law, const T& normal_force) {
  return law.coefficient * (normal_force < 0.0 ? -normal_force : normal_force);
}

}  // namespace mariotte::contact
