#include "mariotte/model/contacts/contact_automaton.hpp"

#include <algorithm>

namespace mariotte::model {

using contact::ContactMode;
using flow::Crossing;

void change(contact::ContactSet& mode, Index j, ContactMode after, std::vector<ContactChange>& changes) {
  if (mode[j] == after) return;
  changes.push_back({j, mode[j], after});
  mode[j] = after;
}

void open_touching(contact::ContactSet& mode, std::vector<ContactChange>& changes) {
  for (Index j = 0; j < std::ssize(mode); ++j)
    if (mode[j] == ContactMode::touching) change(mode, j, ContactMode::open, changes);
}

ContactMode mode_after(ContactMode mode, bool load_fired, double gap, double approach, double noise_speed) {
  switch (mode) {
    case ContactMode::open:
      return approach > noise_speed ? ContactMode::closed : ContactMode::hovering;
    case ContactMode::hovering:
      return ContactMode::closed;
    case ContactMode::slack:
      return load_fired ? ContactMode::closed : ContactMode::open;
    case ContactMode::closed:
      return load_fired && gap < 0 ? ContactMode::slack : ContactMode::open;
    case ContactMode::touching:
      return ContactMode::open;
  }
  return mode;
}

flow::Role role(ContactMode mode) {
  using flow::Role;
  switch (mode) {
    case ContactMode::open:
    case ContactMode::hovering:
      return Role::open;
    case ContactMode::touching:
      return Role::touching;
    case ContactMode::closed:
      return Role::closed;
    case ContactMode::slack:
      return Role::slack;
  }
  return Role::open;
}

Watched watched(ContactMode mode, const contact::Law& law) {
  switch (mode) {
    case ContactMode::open:
    case ContactMode::hovering:
      return {Crossing::falling, Crossing::none};
    case ContactMode::slack:
      return {Crossing::rising, Crossing::rising};
    case ContactMode::touching:
      return {Crossing::none, Crossing::none};
    case ContactMode::closed:
      if (!dissipates(law)) break;
      // The load of a power law falls before the gap opens, or with it; that of another law need not.
      return {power_law(law) ? Crossing::none : Crossing::rising, Crossing::falling};
  }
  return {Crossing::rising, Crossing::none};
}

contact::Force force_in(ContactMode mode, const contact::Law& law, double indentation, double rate) {
  switch (mode) {
    case ContactMode::closed:
      return contact::smooth_force(law, indentation, rate);
    case ContactMode::touching:
      return contact::force(law, std::max(0.0, indentation), rate);
    default:
      return {0, 0, 0};
  }
}

}  // namespace mariotte::model
