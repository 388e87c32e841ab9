// The automaton of one contact, the same in every model; its table is in contact/contact_set.hpp.
#pragma once
#include "mariotte/contact/contact_set.hpp"
#include "mariotte/contact/law.hpp"
#include "mariotte/flow/problem.hpp"

namespace mariotte::model {

/// A contact that passes from one mode to another.
struct ContactChange {
  Index contact;
  contact::ContactMode before;
  contact::ContactMode after;
};

/// Put contact j into a mode and note it, if that is new.
void change(contact::ContactSet& mode, Index j, contact::ContactMode after,
            std::vector<ContactChange>& changes);

/// Contacts that touched but were never pressed noticeably open at the end.
void open_touching(contact::ContactSet& mode, std::vector<ContactChange>& changes);

/// The mode after a guard of the contact has fired: that of its load, or of its gap. An approach of at most
/// `noise_speed` cannot be told from rest.
contact::ContactMode mode_after(contact::ContactMode mode, bool load_fired, double gap, double approach,
                                double noise_speed);

/// What the flows of a row call a mode.
flow::Role role(contact::ContactMode mode);

/// How the guards of a contact are watched; only contacts that dissipate have a load.
struct Watched {
  flow::Crossing gap, load;
};
/// Of a contact in this mode.
Watched watched(contact::ContactMode mode, const contact::Law& law);

/// Force of a contact in a mode and its slopes; zero unless it carries force.
contact::Force force_in(contact::ContactMode mode, const contact::Law& law, double indentation, double rate);

}  // namespace mariotte::model
