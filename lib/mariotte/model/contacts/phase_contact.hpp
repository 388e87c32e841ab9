// A contact of a model as the flows see it that need more than a field.
#pragma once
#include "mariotte/contact/branched_law.hpp"
#include "mariotte/flow/phase_contact.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"

namespace mariotte::model {

/// Open so far. A law that is no sum of powers, and no curve, is no force at all: these flows follow such a
/// contact while it is open only.
inline flow::PhaseContact phase_contact(const ScaledContacts& model, const ContactLayout& at, Index j) {
  const auto law = powers(model.law[j])
                       .value_or(contact::DampedPower{
                           .stiffness = 0, .exponent = 1, .damping = 0, .grows = Damping::as_slope});
  return {.gap = at.gap[j],
          .work = at.work[j],
          .impulse = at.impulse[j],
          .guard = j,
          .load_guard = at.load_guard[j],
          .stiffness = law.stiffness,
          .damping = law.damping,
          .exponent = law.exponent,
          .grows = law.grows,
          .length = model.length[j],
          .noise_depth = model.fading_depth(j),
          .curve = contact::curve(model.law[j])};
}

inline void take_over(const contact::ShiftedPower& power, flow::PhaseContact& contact) {
  contact.stiffness = power.stiffness;
  contact.damping = power.damping;
  contact.grows = power.grows;
  contact.pull = power.pull;
  contact.exponent = power.exponent;
  contact.origin = power.origin;
}

inline void take_over(const contact::BrachDunn& tip, flow::PhaseContact& contact) {
  contact.stiffness = tip.stiffness;
  contact.exponent = 1.5;
  contact.damping = tip.stiffness * tip.damping_hertz;
  contact.grows = Damping::as_force;
  contact.ring = tip.adhesion;
  contact.ring_damping = tip.adhesion * tip.damping_adhesion;
}

inline void take_over(const WidthBranch& width, flow::PhaseContact& contact) {
  contact.width = &width;
  contact.stiffness = 0;
  contact.exponent = 1;
}

/// The branch of a law as the numbers of its contact; `kept` is where it may stay if it has a width. False if
/// it is none of these, or pulls what touches at rest: flows leave out the force of such a contact.
inline bool take_over(const contact::BranchedLaw& law, const contact::Memory& past, WidthBranch& kept,
                      flow::PhaseContact& contact) {
  const bool may_pull = contact.role != flow::Role::touching;
  if (const auto width = law.width_branch(past)) {
    take_over(kept = *width, contact);
    return true;
  }
  if (const auto tip = law.adhesive_tip(); tip && may_pull) {
    take_over(*tip, contact);
    return true;
  }
  const auto power = law.power(past);
  if (!power || (power->pull > 0 && !may_pull)) return false;
  take_over(*power, contact);
  return true;
}

}  // namespace mariotte::model
