// Where each quantity of a chain or a network stands in the state vector.
#pragma once
#include <string>
#include <vector>

#include "mariotte/model/contacts/scaled_contacts.hpp"

namespace mariotte::model {

/// What a guard looks at: the gap, the load, the indentation at which a contact yields, or its rate.
enum class GuardKind : unsigned char { gap, load, yield, turn };

/// Velocities, gaps and two kinds of integrals, of those contacts that need them:
///   work     W = ∫ f δ̇ dt [energy], where energy is dissipated: what is given to the contact, stored or
///   dissipated; impulse  P = ∫ f dt, where momentum alone does not tell it.
/// Guards 0 … m−1 are the gaps of the m contacts. Each contact that goes slack has one more, its load, in the
/// order of the contacts; each whose law watches turns two more, behind all others.
struct ContactLayout {
  static constexpr Index absent = -1;
  Index size = 0;
  std::vector<Index> velocity;       ///< places
  std::vector<Index> gap;            ///< places, one per contact
  std::vector<Index> work;           ///< by contact: its place, or absent
  std::vector<Index> impulse;        ///< by contact: its place, or absent
  std::vector<Index> load_guard;     ///< by contact: guard of its load, or absent
  std::vector<Index> branch_guard;   ///< by contact: guard of its yield, before that of its turns; or absent
  std::vector<Index> guard_contact;  ///< by guard

  Index velocities() const { return std::ssize(velocity); }
  Index contacts() const { return std::ssize(gap); }
  GuardKind kind(Index guard) const {
    const Index j = guard_contact[guard];
    if (guard == j) return GuardKind::gap;
    if (guard == load_guard[j]) return GuardKind::load;
    return guard == branch_guard[j] ? GuardKind::yield : GuardKind::turn;
  }
};

/// Empty every list, and keep its memory.
void clear(ContactLayout& layout);
/// Number the guards, which depend on the laws of the contacts.
void number_guards(const std::vector<contact::Law>& laws, ContactLayout& layout);

/// State at the start; the work of a contact that starts indented is its stored energy.
void initial_state(const ScaledContacts& contacts, const ContactLayout& layout, std::vector<double>& x);

/// "velocity 3", "gap 2", … for messages; counted from 1.
std::string component_name(const ContactLayout& layout, Index component);

}  // namespace mariotte::model
