// A chain or a network as a hybrid system: which contacts act, and what comes after a guard has fired.
#pragma once
#include <algorithm>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/model/contacts/topology_phase.hpp"

namespace mariotte::model {

/// Satisfies hybrid::HybridSystem. Dimensionless; the model's scale leads back.
template <class Topology>
class ContactSystem {
 public:
  using Mode = contact::ContactSet;
  using Change = ContactChange;

  ContactSystem(const ContactSystem&) = delete;
  ContactSystem& operator=(const ContactSystem&) = delete;
  const ContactLayout& layout() const { return layout_; }
  const TopologyPhase<Topology>& phase() const { return phase_; }

  /// Contacts that carry force at 0+: indented ones, touching ones that approach or are driven together, and
  /// touching ones at rest that stand near one of these.
  void mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const {
    contact_set_at(state(x), mode, changes);
  }
  /// What has fired, closed contacts that have faded by then, and touching ones that have left the noise.
  void transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                  std::vector<Change>& changes) const;
  /// No contact carries force, and none comes together: a theorem of rows without outside forces.
  bool is_over(const Mode& mode, ConstState x, bool impacted) const;
  hybrid::Ending ending(const Mode&) const { return hybrid::Ending::separated; }
  /// Contacts that touched but were never pressed noticeably open at the end.
  void finish(Mode& mode, std::vector<Change>& changes) const { open_touching(mode, changes); }
  TopologyPhase<Topology>& problem(Mode& mode) {
    phase_.bind(mode);
    return phase_;
  }

 protected:
  ContactSystem() : phase_(model_, layout_) {}
  ContactState<Topology> state(ConstState x) const { return {{model_, layout_}, x}; }

  typename Topology::Model model_;
  ContactLayout layout_;
  TopologyPhase<Topology> phase_;

 private:
  void fire(Mode& mode, Index guard, ConstState x, std::vector<Change>& changes) const;
  void settle(Mode& mode, Index j, bool has_fired, ConstState x, std::vector<Change>& changes) const;
};

template <class Topology>
void ContactSystem<Topology>::fire(Mode& mode, Index guard, ConstState x,
                                   std::vector<Change>& changes) const {
  const Index j = layout_.guard_contact[guard];
  const bool load_fired = guard != j;
  if (load_fired && role(mode[j]) == flow::Role::open) return;  // its gap has opened at the same instant
  change(mode, j, after(state(x), j, mode[j], load_fired), changes);
  if (mode[j] == contact::ContactMode::closed) press_near(state(x), mode, j, changes);
}

/// What a contact does that no guard has told of.
template <class Topology>
void ContactSystem<Topology>::settle(Mode& mode, Index j, bool has_fired, ConstState x,
                                     std::vector<Change>& changes) const {
  using contact::ContactMode;
  const auto now = state(x);
  if (mode[j] == ContactMode::closed && has_faded(now, j) && !has_fired) {
    change(mode, j, ContactMode::hovering, changes);
  } else if (mode[j] == ContactMode::touching && has_parted(now, j)) {
    change(mode, j, ContactMode::open, changes);
  } else if (mode[j] == ContactMode::touching && has_loaded(now, j)) {
    mode[j] = ContactMode::closed;  // no event
  }
}

template <class Topology>
void ContactSystem<Topology>::transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                                         std::vector<Change>& changes) const {
  for (const Index guard : fired) fire(mode, guard, x, changes);
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (mode[j] == contact::ContactMode::slack && is_loaded_again(state(x), mode, j))
      change(mode, j, contact::ContactMode::closed, changes);
  const auto has_fired = [&](Index j) {
    return std::any_of(fired.begin(), fired.end(),
                       [&](Index guard) { return layout_.guard_contact[guard] == j; });
  };
  for (Index j = 0; j < layout_.contacts(); ++j) settle(mode, j, has_fired(j), x, changes);
}

template <class Topology>
bool ContactSystem<Topology>::is_over(const Mode& mode, ConstState x, bool /*impacted*/) const {
  const auto now = state(x);
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (mode[j] == contact::ContactMode::closed || comes_together(now.topology, j, now.approach(j)))
      return false;
  return true;
}

}  // namespace mariotte::model
