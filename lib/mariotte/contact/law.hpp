// A contact law chosen at run time: any mixture of laws in one scene.
#pragma once
#include <variant>

#include "mariotte/contact/hertz.hpp"
#include "mariotte/contact/linear.hpp"
#include "mariotte/contact/viscoelastic.hpp"

namespace mariotte::contact {

/// The law of one contact.
using Law = std::variant<Linear, Hertz, Viscoelastic>;

/// The law's field before it is cut off at f = 0: what a closed contact follows until a guard says it has let
/// go, so that a step which reaches past that instant meets no kink.
inline Force smooth_force(const Law& law, double indentation, double rate) {
  return std::visit([&](const auto& one) { return smooth_force(one, indentation, rate); }, law);
}

/// Force and slopes at indentation δ ≥ 0 [m] and rate δ̇ [m/s]; all zero where the contact would pull.
template <class AnyLaw>
Force force(const AnyLaw& law, double indentation, double rate) {
  const auto smooth = smooth_force(law, indentation, rate);
  return smooth.value > 0 ? smooth : Force{.value = 0, .by_indentation = 0, .by_rate = 0};
}

/// Elastic energy at an indentation [J].
inline double stored_energy(const Law& law, double indentation) {
  return std::visit([&](const auto& one) { return stored_energy(one, indentation); }, law);
}
/// k [N/m^n].
inline double stiffness(const Law& law) {
  return std::visit([](const auto& one) { return one.stiffness; }, law);
}
/// c [N s/m^n]; 0 without a damper.
inline double damping(const Law& law) {
  return std::visit([](const auto& one) { return damping(one); }, law);
}
/// n of f = k δⁿ.
inline double exponent(const Law& law) {
  return std::visit([](const auto& one) { return exponent(one); }, law);
}

}  // namespace mariotte::contact
