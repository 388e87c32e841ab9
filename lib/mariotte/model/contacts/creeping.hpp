// Contacts whose load k δ + c δ̇ is no more than rounding of velocities makes it: which of them push, and
// which let go [numerics page, "Creeping contacts"].
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "mariotte/model/contacts/contact_modes.hpp"

namespace mariotte::model {

/// Until it settles; a few are usual.
constexpr int most_creeping_sweeps = 100;

/// What rounding of speeds makes of a load, step by step.
template <class Topology>
double load_noise(const ContactState<Topology>& state, Index j) {
  return 64 * epsilon * state.load(j).by_rate * state.model().speed;
}

/// The load of closed contact j is rounding: it creeps, or is about to let go.
template <class Topology>
bool creeps(const ContactState<Topology>& state, const contact::ContactSet& mode, Index j) {
  return mode[j] == contact::ContactMode::closed && contact::goes_slack(state.model().law[j]) &&
         state.load(j).value < load_noise(state, j);
}

/// How fast the load of contact j would grow if it carried no force; `force(i)` is that of contact i.
template <class Topology, class Force>
double growth_under(const ContactState<Topology>& state, Index j, const Force& force) {
  double bend = state.drive(j);
  state.topology.for_each_near(j, [&](Index i) {
    if (i != j) bend -= state.topology.coupling(j, i) * force(i);
  });
  const auto load = state.load(j);
  return load.by_indentation * state.approach(j) + load.by_rate * bend;
}

/// Forces of contacts at a state. Those of contacts that creep are lost in rounding, and are found from what
/// presses them, once for all that are asked.
template <class Topology>
class CreepingForces {
 public:
  CreepingForces(const ContactState<Topology>& state, const contact::ContactSet& mode)
      : state_(state), mode_(mode) {}
  const ContactState<Topology>& state() const { return state_; }
  contact::ContactMode mode(Index j) const { return mode_[j]; }
  /// Whether the load of closed contact j is rounding.
  bool creeps(Index j) const { return model::creeps(state_, mode_, j); }

  /// How fast the load of contact j would grow if it carried no force.
  double free_growth(Index j) {
    bool beside = false;
    state_.topology.for_each_near(j, [&](Index i) { beside = beside || (i != j && creeps(i)); });
    if (!beside) return growth_under(state_, j, [&](Index i) { return state_.force_in(mode_, i); });
    if (force_.empty()) find();
    return growth(j);
  }
  /// The mode of a contact has changed.
  void forget() { force_.clear(); }

 private:
  double growth(Index j) const {
    return growth_under(state_, j, [&](Index i) { return force_[i]; });
  }

  /// Under which no load of those that creep changes, or none where they would pull: projected Gauss-Seidel
  /// iteration from zero, which rises in a row and then ends with the least.
  void find() {
    std::vector<Index> creeping;
    force_.assign(state_.contacts(), 0.0);
    for (Index j = 0; j < state_.contacts(); ++j)
      if (creeps(j))
        creeping.push_back(j);
      else
        force_[j] = state_.force_in(mode_, j);
    for (int sweep = 0; sweep < most_creeping_sweeps; ++sweep) {
      Index moved = 0;
      for (const Index j : creeping) moved += settle(j);
      if (moved == 0) break;
      std::reverse(creeping.begin(), creeping.end());
    }
  }
  /// True if the force of contact j has changed.
  bool settle(Index j) {
    const double held = state_.load(j).by_rate / state_.model().reduced_mass[j], grows = growth(j);
    const double now = grows > 0 && held > 0 ? grows / held : 0;
    const bool moves = std::abs(now - force_[j]) > 1e-6 * now;
    force_[j] = now;
    return moves;
  }

  ContactState<Topology> state_;
  const contact::ContactSet& mode_;
  std::vector<double> force_;
};

/// The load of slack contact j is positive and its neighbours' forces let it grow: it pushes again. Where a
/// load has vanished but for rounding, its guard may stand beyond zero already, and would never fire.
template <class Topology>
bool is_loaded_again(CreepingForces<Topology>& now, Index j) {
  return now.mode(j) == contact::ContactMode::slack && now.state().load(j).value > 0 &&
         now.free_growth(j) > 0;
}

/// The load of contact j has passed zero beyond rounding, and no guard has told: where it stood beyond zero
/// as the phase began, its guard never fires.
template <class Topology>
bool has_passed(CreepingForces<Topology>& now, Index j) {
  return now.mode(j) == contact::ContactMode::slack &&
         now.state().load(j).value > load_noise(now.state(), j) && is_loaded_again(now, j);
}

/// The load of closed contact j is rounding, and would not grow without its force: it has let go. A contact
/// that creeps has such a load for long, whose sign is that of this growth. A load without δ, 1 + a δ̇, fades
/// by itself, and so lets go only if it would fall.
template <class Topology>
bool has_let_go(CreepingForces<Topology>& now, Index j) {
  if (!now.creeps(j)) return false;
  const double growth = now.free_growth(j);
  return growth < 0 || (growth == 0 && now.state().load(j).by_indentation != 0);
}

}  // namespace mariotte::model
