// A contact law chosen at run time: any mixture of laws in one scene.
#pragma once
#include <variant>

#include "mariotte/contact/hertz.hpp"
#include "mariotte/contact/linear.hpp"
#include "mariotte/contact/viscoelastic.hpp"

namespace mariotte::contact {

using Law = std::variant<Linear, Hertz, Viscoelastic>;

inline Force force(const Law& law, double indentation, double rate) {
  return std::visit([&](const auto& one) { return force(one, indentation, rate); }, law);
}
inline double stored_energy(const Law& law, double indentation) {
  return std::visit([&](const auto& one) { return stored_energy(one, indentation); }, law);
}
inline double stiffness(const Law& law) {
  return std::visit([](const auto& one) { return one.stiffness; }, law);
}
inline double damping(const Law& law) {
  return std::visit([](const auto& one) { return damping(one); }, law);
}
inline double exponent(const Law& law) {
  return std::visit([](const auto& one) { return exponent(one); }, law);
}

/// Rate of energy loss f_damping · δ̇ ≥ 0 [W] of a contact that carries force.
inline double dissipation_rate(const Law& law, double indentation, double rate) {
  if (damping(law) == 0) return 0;
  return damping(law) * contact_width(exponent(law), indentation) * rate * rate;
}

}  // namespace mariotte::contact
