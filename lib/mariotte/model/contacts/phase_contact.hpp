// A contact of a model as the flows see it that need more than a field.
#pragma once
#include "mariotte/flow/phase_contact.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"

namespace mariotte::model {

/// Open so far. A law that is no sum of powers is no force at all: these flows follow such a contact while it
/// is open only.
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
          .noise_depth = model.fading_depth(j)};
}

}  // namespace mariotte::model
