#include "mariotte/model/contacts/contact_layout.hpp"

#include <algorithm>

namespace mariotte::model {

void clear(ContactLayout& layout) {
  layout.size = 0;
  layout.clock = ContactLayout::absent;
  for (auto* list : {&layout.velocity, &layout.gap, &layout.work, &layout.impulse, &layout.load_guard,
                     &layout.branch_guard, &layout.guard_contact, &layout.drive_work})
    list->clear();
}

void number_guards(const std::vector<contact::Law>& laws, ContactLayout& layout) {
  const auto add = [&](Index j, bool has_guard, Index guards, std::vector<Index>& places) {
    places.push_back(has_guard ? std::ssize(layout.guard_contact) : ContactLayout::absent);
    if (has_guard) layout.guard_contact.insert(layout.guard_contact.end(), guards, j);
  };
  for (Index j = 0; j < layout.contacts(); ++j) layout.guard_contact.push_back(j);
  for (Index j = 0; j < layout.contacts(); ++j) add(j, contact::goes_slack(laws[j]), 1, layout.load_guard);
  for (Index j = 0; j < layout.contacts(); ++j)
    add(j, contact::watches_turns(laws[j]), 2, layout.branch_guard);
}

void add_drives(Index drives, ContactLayout& layout) {
  if (drives == 0) return;
  layout.clock = layout.size++;
  for (Index k = 0; k < drives; ++k) layout.drive_work.push_back(layout.size++);
  layout.guard_contact.insert(layout.guard_contact.end(), drives, ContactLayout::absent);
}

void initial_state(const ScaledContacts& contacts, const ContactLayout& layout, std::vector<double>& x) {
  x.assign(layout.size, 0.0);
  for (Index i = 0; i < layout.velocities(); ++i) x[layout.velocity[i]] = contacts.velocity[i];
  for (Index j = 0; j < layout.contacts(); ++j) {
    x[layout.gap[j]] = contacts.gap[j];
    if (layout.work[j] != ContactLayout::absent && contacts.gap[j] < 0)
      x[layout.work[j]] = contact::stored_energy(contacts.law[j], -contacts.gap[j]);
  }
}

std::string component_name(const ContactLayout& layout, Index component) {
  const auto find = [&](const std::vector<Index>& places, const char* quantity) -> std::string {
    const auto place = std::find(places.begin(), places.end(), component);
    return place == places.end() ? "" : quantity + std::to_string(place - places.begin() + 1);
  };
  for (const auto& name :
       {find(layout.velocity, "velocity "), find(layout.gap, "gap "), find(layout.work, "work "),
        find(layout.impulse, "impulse "), find(layout.drive_work, "work of drive ")})
    if (!name.empty()) return name;
  if (component == layout.clock) return "time";
  return "component " + std::to_string(component);
}

}  // namespace mariotte::model
