// The automaton of one contact, the same in every model; its table is in contact/contact_set.hpp.
#pragma once
#include "mariotte/contact/branched_law.hpp"
#include "mariotte/contact/contact_set.hpp"
#include "mariotte/contact/law.hpp"
#include "mariotte/flow/problem.hpp"

namespace mariotte::model {

/// A contact that passes from one mode, or from one branch of its law, to another.
struct ContactChange {
  Index contact;
  contact::ContactMode before;
  contact::ContactMode after;
  contact::Branch branch_before = contact::Branch::elastic;
  contact::Branch branch_after = contact::Branch::elastic;
  double approach = 0;  ///< δ̇ at that instant; nan where the contact has been indented from the start
};

/// Put contact j into a mode and note it, if that is new. A law with branches begins on one of them, and
/// loses where it begins and ends what adhesion gives and takes there.
void change(contact::ContactSet& mode, Index j, contact::ContactMode after, const contact::Law& law,
            std::vector<ContactChange>& changes);

/// Contact j has reached the indentation at which it yields, or its rate has changed its sign.
void yield(contact::ContactSet& mode, Index j, std::vector<ContactChange>& changes);
void turn(contact::ContactSet& mode, Index j, const contact::Law& law, double indentation,
          std::vector<ContactChange>& changes);

/// What a closed contact that starts indented remembers: it has been loaded to there and no further.
void start_indented(contact::Memory& past, const contact::Law& law, double indentation, double rate);

/// What contact j remembers; nothing if no law of the model remembers.
inline contact::Memory memory_of(const contact::ContactSet& mode, Index j) {
  return mode.memory.empty() ? contact::Memory{} : mode.memory[j];
}
/// All contacts open, without a past; memory only where a law remembers.
void reset(contact::ContactSet& mode, const std::vector<contact::Law>& laws);
/// Contacts first to last − 1 of a set.
void copy_slice(const contact::ContactSet& from, Index first, Index last, contact::ContactSet& to);
/// Put such a slice back.
void put_slice(const contact::ContactSet& slice, Index first, contact::ContactSet& to);

/// Contacts that touched but were never pressed noticeably open at the end.
void open_touching(contact::ContactSet& mode, const std::vector<contact::Law>& laws,
                   std::vector<ContactChange>& changes);

/// The mode after a guard of the contact has fired: that of its load, or of its gap. An approach of at most
/// `noise_speed` cannot be told from rest.
contact::ContactMode mode_after(contact::ContactMode mode, bool load_fired, double gap, double approach,
                                double noise_speed);

/// What the flows of a row call a mode.
flow::Role role(contact::ContactMode mode);

/// How the guards of a contact are watched. Only contacts that go slack have a load; only those whose law has
/// branches have an indentation to yield at, and turns.
struct Watched {
  flow::Crossing gap, load, yield = flow::Crossing::none, turn = flow::Crossing::none;
};
/// Of a contact in this mode.
Watched watched(contact::ContactMode mode, const contact::Law& law, const contact::Memory& past = {});

/// Force of a contact in a mode and its slopes; zero unless it carries force.
contact::Force force_in(contact::ContactMode mode, const contact::Law& law, double indentation, double rate,
                        const contact::Memory& past = {});

/// Gap at which the contact's gap guard stands, with the sign that makes gap + level the guard: where it
/// closes, or a closed one opens. `noise_depth` is how much deeper a hovering contact gets first.
double level(contact::ContactMode mode, const contact::Law& law, const contact::Memory& past,
             double noise_depth);

}  // namespace mariotte::model
