// Where each quantity of a chain or a network stands in the state vector.
#pragma once
#include <string>
#include <vector>

#include "mariotte/model/contacts/scaled_contacts.hpp"

namespace mariotte::model {

/// What a guard looks at: the gap, the load, the indentation at which a contact yields, its rate; or the time
/// until the next kink of a drive.
enum class GuardKind : unsigned char { gap, load, yield, turn, kink };

/// Velocities, gaps and two kinds of integrals, of those contacts that need them:
///   work     W = ∫ f δ̇ dt [energy], where energy is dissipated: what is given to the contact, stored or
///   dissipated; impulse  P = ∫ f dt, where momentum alone does not tell it.
/// What is driven has a clock, the time, and for each drive the work that it does.
/// Guards 0 … m−1 are the gaps of the m contacts. Each contact that goes slack has one more, its load, in the
/// order of the contacts; each whose law watches turns two more, behind all others. Each drive has the last.
struct ContactLayout {
  static constexpr Index absent = -1;
  Index size = 0;
  std::vector<Index> velocity;       ///< places
  std::vector<Index> gap;            ///< places, one per contact
  std::vector<Index> work;           ///< by contact: its place, or absent
  std::vector<Index> impulse;        ///< by contact: its place, or absent
  std::vector<Index> load_guard;     ///< by contact: guard of its load, or absent
  std::vector<Index> branch_guard;   ///< by contact: guard of its yield, before that of its turns; or absent
  std::vector<Index> guard_contact;  ///< by guard; absent of drives
  Index clock = absent;              ///< place
  std::vector<Index> drive_work;     ///< places, one per drive

  Index velocities() const { return std::ssize(velocity); }
  Index contacts() const { return std::ssize(gap); }
  Index drives() const { return std::ssize(drive_work); }
  /// The guard of drive k.
  Index kink_guard(Index k) const { return std::ssize(guard_contact) - drives() + k; }
  GuardKind kind(Index guard) const {
    const Index j = guard_contact[guard];
    if (j == absent) return GuardKind::kink;
    if (guard == j) return GuardKind::gap;
    if (guard == load_guard[j]) return GuardKind::load;
    return guard == branch_guard[j] ? GuardKind::yield : GuardKind::turn;
  }
};

/// Empty every list, and keep its memory.
void clear(ContactLayout& layout);
/// Number the guards, which depend on the laws of the contacts.
void number_guards(const std::vector<contact::Law>& laws, ContactLayout& layout);

/// Places and guards of so many drives, behind all others.
void add_drives(Index drives, ContactLayout& layout);

/// State at the start; the work of a contact that starts indented is its stored energy.
void initial_state(const ScaledContacts& contacts, const ContactLayout& layout, std::vector<double>& x);

/// "velocity 3", "gap 2", … for messages; counted from 1.
std::string component_name(const ContactLayout& layout, Index component);

}  // namespace mariotte::model
