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

/// Forces of all contacts. Those that creep have the forces under which no load changes, or none where they
/// would pull: projected Gauss-Seidel iteration from zero, which rises in a row and then ends with the least.
template <class Topology>
std::vector<double> creeping_forces(const ContactState<Topology>& state, const contact::ContactSet& mode) {
  std::vector<double> force(state.contacts());
  std::vector<Index> creeping;
  for (Index j = 0; j < state.contacts(); ++j)
    if (creeps(state, mode, j))
      creeping.push_back(j);
    else
      force[j] = state.force_in(mode, j);
  const auto settle = [&](Index j) {
    const double held = state.load(j).by_rate / state.model().reduced_mass[j];
    const double growth = growth_under(state, j, [&](Index i) { return force[i]; });
    const double now = growth > 0 && held > 0 ? growth / held : 0;
    const bool moves = std::abs(now - force[j]) > 1e-6 * now;
    force[j] = now;
    return moves;
  };
  for (int sweep = 0; sweep < most_creeping_sweeps; ++sweep) {
    Index moved = 0;
    for (const Index j : creeping) moved += settle(j);
    if (moved == 0) break;
    std::reverse(creeping.begin(), creeping.end());
  }
  return force;
}

/// How fast the load of contact j would grow if it carried no force. What creeps beside it has a force that
/// is lost in rounding, and is computed from what presses it.
template <class Topology>
double free_growth(const ContactState<Topology>& state, const contact::ContactSet& mode, Index j) {
  bool beside = false;
  state.topology.for_each_near(j, [&](Index i) { beside = beside || (i != j && creeps(state, mode, i)); });
  if (!beside) return growth_under(state, j, [&](Index i) { return state.force_in(mode, i); });
  const auto force = creeping_forces(state, mode);
  return growth_under(state, j, [&](Index i) { return force[i]; });
}

/// The load of slack contact j is positive and its neighbours' forces let it grow: it pushes again. Where a
/// load has vanished but for rounding, its guard may stand beyond zero already, and would never fire.
template <class Topology>
bool is_loaded_again(const ContactState<Topology>& state, const contact::ContactSet& mode, Index j) {
  return state.load(j).value > 0 && free_growth(state, mode, j) > 0;
}

/// The load of contact j has passed zero beyond rounding, and no guard has told: where it stood beyond zero
/// as the phase began, its guard never fires.
template <class Topology>
bool has_passed(const ContactState<Topology>& state, const contact::ContactSet& mode, Index j) {
  return mode[j] == contact::ContactMode::slack && state.load(j).value > load_noise(state, j) &&
         is_loaded_again(state, mode, j);
}

/// The load of closed contact j is rounding, and would not grow without its force: it has let go. A contact
/// that creeps has such a load for long, whose sign is that of this growth.
template <class Topology>
bool has_let_go(const ContactState<Topology>& state, const contact::ContactSet& mode, Index j) {
  return creeps(state, mode, j) && !(free_growth(state, mode, j) > 0);
}

}  // namespace mariotte::model
