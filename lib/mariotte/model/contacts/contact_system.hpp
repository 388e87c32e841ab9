// A chain or a network as a hybrid system: which contacts act, and what comes after a guard has fired.
#pragma once
#include <algorithm>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/model/contacts/bound.hpp"
#include "mariotte/model/contacts/creeping.hpp"
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
  /// Kinks of drives come before all: a prescribed velocity may jump there.
  void transition(Mode& mode, const std::vector<Index>& fired, State x, std::vector<Change>& changes) const;
  /// Never where there is a drive. No contact carries force, and none comes together: a theorem of rows
  /// without outside forces. Or what adhesion holds together stays so for ever, which ends a run without a
  /// time limit only.
  bool is_over(const Mode& mode, ConstState x, bool impacted) const;
  hybrid::Ending ending(const Mode& mode) const;
  /// Angular frequencies of what rings on at the ending `bound`; none at any other.
  std::vector<double> ringing(const Mode& mode, ConstState x) const {
    return model::ringing(held_together(state(x, &mode), mode));
  }
  std::vector<LackedSpeed> lacked_speeds(const Mode& mode, ConstState x) const {
    return model::lacked_speeds(held_together(state(x, &mode), mode));
  }
  /// Contacts that touched but were never pressed noticeably open at the end.
  void finish(Mode& mode, std::vector<Change>& changes) const { open_touching(mode, model_.law, changes); }
  TopologyPhase<Topology>& problem(Mode& mode) {
    phase_.bind(mode, !stay_);
    return phase_;
  }
  /// As `transition`, within the phase of `problem`: a contact without a damper or a memory opens while
  /// others push on. False, and nothing done, if it is something else.
  bool opens_within(Mode& mode, Index guard, double approach, std::vector<Change>& changes);

 protected:
  ContactSystem() : phase_(model_, layout_) {}
  ContactState<Topology> state(ConstState x, const Mode* mode = nullptr) const {
    return {{model_, layout_}, x, mode};
  }

  typename Topology::Model model_;
  ContactLayout layout_;
  TopologyPhase<Topology> phase_;
  bool stay_ = false;  ///< what rings or falls back is followed up to the time limit

 private:
  bool pass_kinks(Mode& mode, const std::vector<Index>& fired, State x) const;
  void redirect(Mode& mode, Index j, ConstState x, std::vector<Change>& changes) const;
  void fire(Mode& mode, Index guard, ConstState x, std::vector<Change>& changes) const;
  void settle(Mode& mode, Index j, const std::vector<Index>& fired, CreepingForces<Topology>& forces,
              std::vector<Change>& changes) const;
};

template <class Topology>
void ContactSystem<Topology>::fire(Mode& mode, Index guard, ConstState x,
                                   std::vector<Change>& changes) const {
  const Index j = layout_.guard_contact[guard];
  const auto kind = layout_.kind(guard);
  if (kind == GuardKind::kink) return;
  if (kind != GuardKind::gap && role(mode[j]) == flow::Role::open) return;  // its gap has opened at once
  const auto now = state(x, &mode);
  if (kind == GuardKind::yield) return yield(mode, j, changes);
  if (kind == GuardKind::turn) return turn(mode, j, model_.law[j], -now.gap(j), changes);
  change(mode, j, after(now, j, mode[j], kind == GuardKind::load), model_.law[j], changes);
  if (mode[j] == contact::ContactMode::closed) press_near(now, mode, j, changes);
}

/// What a contact does that no guard has told of.
template <class Topology>
void ContactSystem<Topology>::settle(Mode& mode, Index j, const std::vector<Index>& fired,
                                     CreepingForces<Topology>& forces, std::vector<Change>& changes) const {
  using contact::ContactMode;
  const auto& now = forces.state();
  if (mode[j] == ContactMode::touching) {
    if (has_parted(now, j))
      change(mode, j, ContactMode::open, model_.law[j], changes);
    else if (has_loaded(now, j))
      mode[j] = ContactMode::closed;  // no event
    return;
  }
  if (mode[j] != ContactMode::closed) return;
  const bool fades = has_faded(now, j);
  if (!fades && !has_let_go(forces, j)) return;
  const auto is_own = [&](Index guard) { return layout_.guard_contact[guard] == j; };
  if (std::none_of(fired.begin(), fired.end(), is_own))
    change(mode, j, fades ? ContactMode::hovering : ContactMode::slack, model_.law[j], changes);
}

/// Drives that have come to the end of a piece go on with the next. True if a velocity is prescribed anew.
template <class Topology>
bool ContactSystem<Topology>::pass_kinks(Mode& mode, const std::vector<Index>& fired, State x) const {
  bool moves = false;
  for (const Index guard : fired) {
    if (layout_.kind(guard) != GuardKind::kink) continue;
    const Index k = guard - layout_.kink_guard(0);
    const auto& drive = model_.drive[k];
    const auto& next = drive.signal.piece[++mode.piece[k]];
    x[layout_.clock] = next.start;
    if (drive.is_force) continue;
    moves = true;
    for (const auto& [dof, coefficient] : drive.direction)
      x[layout_.velocity[dof]] = coefficient * value(next, next.start);
  }
  return moves;
}

/// What a jump of its rate does to contact j, no guard having crossed: it turns, or its load changes its
/// sign.
template <class Topology>
void ContactSystem<Topology>::redirect(Mode& mode, Index j, ConstState x,
                                       std::vector<Change>& changes) const {
  using contact::ContactMode;
  const auto now = state(x, &mode);
  const auto& law = model_.law[j];
  const double rate = now.approach(j);
  const auto turns = watched(mode[j], law, now.past(j)).turn;
  if (turns != flow::Crossing::none && static_cast<double>(turns) * rate > model_.noise_speed)
    turn(mode, j, law, -now.gap(j), changes);
  if (!contact::goes_slack(law) || !(now.gap(j) < 0)) return;
  const double load = now.load(j).value;
  if (mode[j] == ContactMode::closed && load < 0) change(mode, j, ContactMode::slack, law, changes);
  if (mode[j] == ContactMode::slack && load > 0) change(mode, j, ContactMode::closed, law, changes);
}

template <class Topology>
void ContactSystem<Topology>::transition(Mode& mode, const std::vector<Index>& fired, State x,
                                         std::vector<Change>& changes) const {
  const auto known = changes.size();
  if (pass_kinks(mode, fired, x))
    for (Index j = 0; j < layout_.contacts(); ++j) redirect(mode, j, x, changes);
  for (const Index guard : fired) fire(mode, guard, x, changes);
  CreepingForces<Topology> forces(state(x, &mode), mode);
  const auto for_each_contact = [&](const auto& use) {
    for (Index j = 0, count = layout_.contacts(); j < count; ++j) {
      if (mode[j] == contact::ContactMode::open) continue;  // only its guard can change that
      const auto before = changes.size();
      use(j);
      if (changes.size() != before) forces.forget();
    }
  };
  for_each_contact([&](Index j) {
    if (is_loaded_again(forces, j)) change(mode, j, contact::ContactMode::closed, model_.law[j], changes);
  });
  for (auto settled = changes.size() + 1; settled != changes.size();) {  // what lets go may have held others
    settled = changes.size();
    for_each_contact([&](Index j) { settle(mode, j, fired, forces, changes); });
  }
  tell_approach(state(x, &mode), known, changes);
}

template <class Topology>
bool ContactSystem<Topology>::opens_within(Mode& mode, Index guard, double approach,
                                           std::vector<Change>& changes) {
  constexpr Index fewest = 3;  // one that would be left alone is followed by another flow
  const Index j = layout_.guard_contact[guard];
  if (layout_.kind(guard) != GuardKind::gap || mode[j] != contact::ContactMode::closed) return false;
  if (!mode.memory.empty() || phase_.active() < fewest) return false;
  change(mode, j, contact::ContactMode::open, model_.law[j], changes);
  changes.back().approach = approach;
  phase_.open(j);
  return true;
}

template <class Topology>
bool ContactSystem<Topology>::is_over(const Mode& mode, ConstState x, bool /*impacted*/) const {
  if (layout_.drives() > 0) return false;
  const auto now = state(x, &mode);
  const auto is_closed = [](contact::ContactMode one) { return one == contact::ContactMode::closed; };
  if (std::any_of(mode.begin(), mode.end(), is_closed)) return !stay_ && is_bound(held_together(now, mode));
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (comes_together(now.topology, j, now.approach(j))) return false;
  return true;
}

template <class Topology>
hybrid::Ending ContactSystem<Topology>::ending(const Mode& mode) const {
  const bool holds = std::find(mode.begin(), mode.end(), contact::ContactMode::closed) != mode.end();
  return holds ? hybrid::Ending::bound : hybrid::Ending::separated;
}

}  // namespace mariotte::model
