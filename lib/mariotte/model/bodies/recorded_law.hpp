// Contact laws on a tape: powers δⁿ⁻¹ (k δ + c δ̇) and δⁿ (k + c δ̇) with n = 1 or 3/2, also from another
// origin and less a pull, branches in the root of a contact radius, and tips with a ring of adhesion.
#pragma once
#include <cmath>
#include <optional>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/contact/law.hpp"
#include "mariotte/series/tape.hpp"

namespace mariotte::model {

/// The force of a branch, its slopes, and what its series depends on.
struct RecordedForce {
  series::Traced value = {}, by_indentation = {}, by_rate = {};
  series::Traced left = {};                 ///< indentation until the contact lets go
  std::optional<series::Traced> root = {};  ///< vanishes like √left there, if anything does
  double exponent = 0;                      ///< of the force in `left`; 0 if it does not vanish with it
};

/// The present branch of a law as a power, if that is known on a tape.
inline std::optional<contact::ShiftedPower> recorded_power(const contact::Law& law,
                                                           const contact::Memory& past) {
  std::optional<contact::ShiftedPower> power;
  if (const auto own = contact::powers(law))
    power = {.stiffness = own->stiffness,
             .exponent = own->exponent,
             .origin = 0,
             .damping = own->damping,
             .grows = own->grows};
  else if (const auto* branches = contact::branched(law))
    power = branches->power(past);
  if (!power || (power->exponent != 1 && power->exponent != 1.5)) return std::nullopt;
  if (power->damping > 0 && power->grows == Damping::as_root) return std::nullopt;
  return power;
}

inline std::optional<WidthBranch> recorded_width(const contact::Law& law, const contact::Memory& past) {
  const auto* branches = contact::branched(law);
  return branches ? branches->width_branch(past) : std::nullopt;
}

inline std::optional<contact::BrachDunn> recorded_tip(const contact::Law& law) {
  const auto* branches = contact::branched(law);
  return branches ? branches->adhesive_tip() : std::nullopt;
}

inline bool can_be_recorded(const contact::Law& law, const contact::Memory& past) {
  return recorded_power(law, past) || recorded_width(law, past) || recorded_tip(law);
}

/// One that begins within `noise` of its origin does so there, to the last bit.
inline RecordedForce recorded_force(const contact::ShiftedPower& law, const series::Traced& depth,
                                    const series::Traced& rate, double noise) {
  using series::Traced;
  RecordedForce f{.left = depth - law.origin, .exponent = law.pull > 0 ? 0 : law.exponent};
  if (law.origin != 0 && std::abs(f.left.value()) <= noise && rate.value() > 0) f.left = at_onset(f.left);
  const double n = law.exponent;
  if (n == 1.5) f.root = sqrt(f.left);
  const Traced width = f.root ? *f.root : Traced(1.0);
  if (law.damping > 0 && law.grows == Damping::as_force) {
    const Traced push = width * (law.stiffness + law.damping * rate);
    f.value = push * f.left - law.pull;
    f.by_rate = law.damping * (width * f.left);
    f.by_indentation = n * push;
    return f;
  }
  f.value = width * (law.stiffness * f.left + law.damping * rate) - law.pull;
  f.by_rate = law.damping * width;
  f.by_indentation = n * law.stiffness * width;
  if (law.damping > 0 && n > 1)
    f.by_indentation = f.by_indentation + (n - 1) * law.damping * width * (rate / f.left);
  return f;
}

/// With u = κ w, κ³ = sR: δ = δ₀ + κ s (w⁴ − w).
inline RecordedForce recorded_force(const WidthBranch& branch, const series::Traced& depth,
                                    const series::Traced& rate) {
  using series::Traced;
  const auto& curve = branch.curve;
  const double unit = std::cbrt(curve.s * curve.radius);
  const Traced w = width_of((1 / (unit * curve.s)) * (depth - curve.origin)), u = unit * w;
  const Traced bend = 4.0 * (w * (w * w)) - 1.0;
  Traced push = branch.push[6], slope = 6 * branch.push[6];
  for (int i = 5; i >= 0; --i) push = push * u + branch.push[i];
  for (int i = 5; i >= 1; --i) slope = slope * u + i * branch.push[i];
  return {.value = push + branch.damping * (u * u) * rate,
          .by_indentation = (slope + 2 * branch.damping * u * rate) / (curve.s * bend),
          .by_rate = branch.damping * (u * u),
          .left = depth - curve.indentation(curve.last()),
          .root = bend};
}

inline RecordedForce recorded_force(const contact::BrachDunn& law, const series::Traced& depth,
                                    const series::Traced& rate) {
  using series::Traced;
  const Traced width = sqrt(depth), press = law.stiffness * (1.0 + law.damping_hertz * rate),
               pull = law.adhesion * (1.0 - law.damping_adhesion * rate);
  return {
      .value = width * (press * depth - pull),
      .by_indentation = 1.5 * (press * width) - 0.5 * (pull * (width / depth)),
      .by_rate = width * (law.stiffness * law.damping_hertz * depth + law.adhesion * law.damping_adhesion),
      .left = depth,
      .root = width,
      .exponent = 0.5};
}

inline RecordedForce recorded_force(const contact::Law& law, const contact::Memory& past,
                                    const series::Traced& depth, const series::Traced& rate, double noise) {
  if (const auto width = recorded_width(law, past)) return recorded_force(*width, depth, rate);
  if (const auto tip = recorded_tip(law)) return recorded_force(*tip, depth, rate);
  return recorded_force(*recorded_power(law, past), depth, rate, noise);
}

}  // namespace mariotte::model
