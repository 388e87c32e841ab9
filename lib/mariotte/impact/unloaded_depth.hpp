// Indentations that no force explains, of chains and networks.
#pragma once
#include "mariotte/contact/contact_set.hpp"
#include "mariotte/impact/gate.hpp"
#include "mariotte/model/contacts/contact_automaton.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"

namespace mariotte::impact {

/// A contact that is indented and has let go must not approach: its damper would push again.
inline bool is_slack(contact::ContactMode mode) {
  return mode == contact::ContactMode::slack;
}

/// Largest indentation of a contact without force at state x, in units of what cannot be told from rest.
inline double unloaded_depth(const model::ScaledContacts& contacts, const model::ContactLayout& layout,
                             const contact::ContactSet& mode, ConstState x, double accuracy) {
  using contact::ContactMode;
  double worst = 0;
  for (Index j = 0; j < contacts.contacts(); ++j) {
    if (mode[j] != ContactMode::open && mode[j] != ContactMode::hovering) continue;
    const double allowed =
        noise_depths * contacts.noise_depth[j] + balance_allowance * accuracy * contacts.length[j];
    const double closing = model::level(ContactMode::open, contacts.law[j], model::memory_of(mode, j), 0);
    const double depth = -(x[layout.gap[j]] + closing) / allowed;
    worst = depth <= worst ? worst : depth;  // a gap that is not a number counts
  }
  return worst;
}

}  // namespace mariotte::impact
