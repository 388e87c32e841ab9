// A contact law chosen at run time: any mixture of laws in one scene.
#pragma once
#include <string_view>
#include <variant>

#include "mariotte/contact/custom_law.hpp"
#include "mariotte/contact/hertz.hpp"
#include "mariotte/contact/power_law.hpp"

namespace mariotte::contact {

/// The law of one contact. Closed forms and series are made for powers, branches and segments; CVODE follows
/// any.
using Law = std::variant<PowerLaw, SharedLaw>;

/// The power law, or null if it is another one.
inline const PowerLaw* power_law(const Law& law) {
  return std::get_if<PowerLaw>(&law);
}

/// The force if it is a sum of powers.
inline std::optional<DampedPower> powers(const Law& law) {
  if (const auto* power = power_law(law))
    return DampedPower{.stiffness = power->stiffness,
                       .exponent = power->exponent,
                       .damping = power->damping,
                       .grows = Damping::as_slope};
  return std::get<SharedLaw>(law)->powers();
}

/// The force as cubic segments, or null if it is not that.
inline const CubicCurve* curve(const Law& law) {
  return power_law(law) ? nullptr : std::get<SharedLaw>(law)->curve();
}

/// The law if it has branches, or null.
inline const BranchedLaw* branched(const Law& law) {
  return power_law(law) ? nullptr : std::get<SharedLaw>(law)->branched();
}

/// `use` with the law as what it is, a PowerLaw or a CustomLaw.
template <class Use>
auto with(const Law& law, Use&& use) {
  if (const auto* power = power_law(law)) return use(*power);
  return use(*std::get<SharedLaw>(law));
}

/// The law's field before it is cut off at f = 0: what a closed contact follows until a guard says it has let
/// go, so that a step which reaches past that instant meets no kink.
inline Force smooth_force(const Law& law, double indentation, double rate) {
  return with(law, [&](const auto& one) { return smooth_force(one, indentation, rate); });
}

/// Force and slopes at indentation δ ≥ 0 [m] and rate δ̇ [m/s]; all zero where the contact would pull.
template <class AnyLaw>
Force force(const AnyLaw& law, double indentation, double rate) {
  const auto smooth = smooth_force(law, indentation, rate);
  return smooth.value > 0 ? smooth : Force{.value = 0, .by_indentation = 0, .by_rate = 0};
}

/// What has the sign of the force, with slopes.
inline Force load(const Law& law, double indentation, double rate) {
  return with(law, [&](const auto& one) { return load(one, indentation, rate); });
}

/// Elastic energy at an indentation [J].
double stored_energy(const Law& law, double indentation);
/// True of a power law with n = 1, damped or not.
inline bool is_linear(const Law& law) {
  const auto* power = power_law(law);
  return power && power->exponent == 1;
}
/// True if the contact loses energy: it may go slack, and the work put into it is integrated.
inline bool dissipates(const Law& law) {
  if (const auto* power = power_law(law)) return dissipates(*power);
  return std::get<SharedLaw>(law)->dissipates();
}
/// True if the force depends on the rate.
bool is_damped(const Law& law);
/// True if the contact can be indented without force: its damper may take all of it.
inline bool goes_slack(const Law& law) {
  return dissipates(law) && !branched(law);
}
/// True if the force of the contact can pull.
bool pulls(const Law& law);
/// True if the force of the contact holds bodies at rest together.
bool adheres(const Law& law);
/// True if the signs of its rate of indentation are events.
bool watches_turns(const Law& law);
/// Indentation at which the contact carries a force at rest [m].
double static_indentation(const Law& law, double force);
/// The same; none if it never carries that much, where the other throws InvalidParameter.
std::optional<double> find_static_indentation(const Law& law, double force);

/// "linear", "hertz", "viscoelastic", or the name that another law gives itself.
std::string_view name(const Law& law);
/// The numbers of a law, as scenes call them.
std::vector<LawParameter> parameters(const Law& law);

/// k [N/m^n] of a power law. Throws InvalidParameter of any other, as the next two do.
double stiffness(const Law& law);
/// c [N s/m^n] of a power law; 0 without a damper.
double damping(const Law& law);
/// n of a power law.
double exponent(const Law& law);

}  // namespace mariotte::contact
