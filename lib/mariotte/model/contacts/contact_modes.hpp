// Which contacts of a chain or a network act, and when one loads, fades or parts: the rules beside the
// guards.
//
// A Topology says what a contact moves and what moves it. ChainTopology and NetworkTopology are the two:
//   model, at                the ScaledContacts and the ContactLayout
//   approach(x, j)           δ̇ of contact j, −G_j v
//   drive(j)                 δ̈ by outside forces alone
//   acceleration(i)          of velocity i by outside forces alone
//   coupling(j, i)           −∂δ̈_j/∂f_i, G_j M⁻¹ G_iᵀ
//   rest_speed()             approach that equal velocities leave by rounding
//   for_each_near(j, use)    the contacts that the push of contact j moves; itself may be among them
//   for_each_direction(j, use), for_each_push(j, use)
//                            use(place of a velocity, coefficient) for the terms of G_j and of M⁻¹ G_jᵀ
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mariotte/model/contacts/contact_automaton.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"

namespace mariotte::model {

/// A chain or a network at one state.
template <class Topology>
struct ContactState {
  Topology topology;
  ConstState x;
  const contact::ContactSet* set = nullptr;  ///< what contacts remember; null if nothing yet

  const ScaledContacts& model() const { return topology.model; }
  Index contacts() const { return topology.at.contacts(); }
  double gap(Index j) const { return x[topology.at.gap[j]]; }
  contact::Memory past(Index j) const { return set ? memory_of(*set, j) : contact::Memory{}; }
  /// Gap less that at which the contact closes: a dent stays.
  double clearance(Index j) const {
    if (set && set->memory.empty()) return gap(j);
    return gap(j) + level(contact::ContactMode::open, model().law[j], past(j), 0);
  }
  double approach(Index j) const { return topology.approach(x, j); }
  /// δ̈ of contact j by outside forces and drives.
  double drive(Index j) const {
    double bend = topology.drive(j);
    for (Index k = 0; k < topology.at.drives(); ++k) {
      const auto& drive = model().drive[k];
      const double change = value(drive.change.piece[set->piece[k]], x[topology.at.clock]);
      for (const auto& answer : drive.response)
        topology.for_each_direction(j, [&](Index place, double g) {
          if (place == topology.at.velocity[answer.dof]) bend -= g * answer.coefficient * change;
        });
    }
    return bend;
  }
  double force_in(const contact::ContactSet& mode, Index j) const {
    return model::force_in(mode[j], model().law[j], -gap(j), approach(j), memory_of(mode, j)).value;
  }
  contact::Force load(Index j) const { return contact::load(model().law[j], -gap(j), approach(j)); }
};

/// The bodies of contact j approach or, where an outside force drives them together, do not part: they rest
/// on each other or will meet again before they have parted.
template <class Topology>
bool comes_together(const Topology& topology, Index j, double approach) {
  const double slow = topology.model.noise_speed;
  return approach > (topology.drive(j) > 0 ? -slow : slow);
}

/// The mode of contact j after its gap, or its load, has fired.
template <class Topology>
contact::ContactMode after(const ContactState<Topology>& state, Index j, contact::ContactMode before,
                           bool load_fired) {
  const bool adheres = contact::adheres(state.model().law[j]);
  return mode_after(before, load_fired, state.gap(j), state.approach(j),
                    adheres ? -infinity : state.model().noise_speed);
}

/// A closed contact so shallow, and moving so slowly, that its end would be an event made of noise: it has
/// let go.
template <class Topology>
bool has_faded(const ContactState<Topology>& state, Index j) {
  const auto& model = state.model();
  return std::abs(state.approach(j)) <= model.fade_speed_ratio * model.noise_speed &&
         -state.clearance(j) < 0.5 * model.fading_depth(j) && !contact::adheres(model.law[j]);
}

/// A touching contact has left the noise.
template <class Topology>
bool has_loaded(const ContactState<Topology>& state, Index j) {
  return -state.clearance(j) > 2 * state.model().fading_depth(j) && state.load(j).value > 0;
}

/// A contact that touched at rest has been drawn apart instead of pressed.
template <class Topology>
bool has_parted(const ContactState<Topology>& state, Index j) {
  return state.clearance(j) > 2 * state.model().fading_depth(j);
}

/// Contact j touches at rest.
template <class Topology>
bool rests(const ContactState<Topology>& state, contact::ContactMode mode, Index j) {
  return mode == contact::ContactMode::open && state.clearance(j) == 0 &&
         std::abs(state.approach(j)) <= state.topology.rest_speed();
}

/// Force of contact i some time from now, at the most that it can be indented until then by what moves it
/// now.
template <class Topology>
double force_after(const ContactState<Topology>& state, const contact::ContactSet& mode, Index i,
                   double time) {
  const auto& model = state.model();
  const double rate = state.approach(i);
  const double deeper = rate * time + 0.5 * std::max(0.0, state.topology.drive(i)) * time * time;
  const double depth = std::max(0.0, deeper - state.gap(i)) + epsilon * model.length[i];
  return force_in(mode[i], model.law[i], depth, rate, memory_of(mode, i)).value;
}

/// What bends the motion of contact j by then: outside forces, and those of its neighbours.
struct Bend {
  double sum, size;  ///< δ̈, and the sum of the magnitudes of its parts
  bool is_pulled;    ///< by outside forces, or by what a neighbour pulls with
};
template <class Topology>
Bend bend_after(const ContactState<Topology>& state, const contact::ContactSet& mode, Index j, double time) {
  const double drive = state.topology.drive(j);
  Bend bend{drive, std::abs(drive), drive < 0};
  state.topology.for_each_near(j, [&](Index i) {
    if (i == j || !contact::carries_force(mode[i])) return;
    const double force = force_after(state, mode, i, time), part = -state.topology.coupling(j, i) * force;
    bend.is_pulled |= force < 0;
    bend.sum += part;
    bend.size += std::abs(part);
  });
  return bend;
}

/// A contact that touches at rest opens by more than `least` within a time, its motion bent by `bend(t)`.
template <class Function>
bool opens_beyond(double least, double time, Function&& bend) {
  constexpr int steps = 16;
  const double step = time / steps;
  double rate = 0, gap = 0;
  for (int k = 0; k < steps && gap >= 0 && gap <= least; ++k) {
    const double change = -bend((k + 0.5) * step) * step;
    gap += (rate + 0.5 * change) * step;
    rate += change;
  }
  return gap > least;
}

/// Contact j, which touches at rest, is drawn apart at once, by outside forces or adhesion of its neighbours,
/// and leaves the noise before anything presses it. One that is pressed before stays touching: not every flow
/// would find so short a gap.
template <class Topology>
bool is_drawn_apart(const ContactState<Topology>& state, const contact::ContactSet& mode, Index j) {
  const double scale = state.model().time[j], noise = 2 * state.model().fading_depth(j);
  const auto at_once = bend_after(state, mode, j, epsilon * scale);
  if (!at_once.is_pulled || !(at_once.sum < -64 * epsilon * at_once.size)) return false;
  const auto bend = [&](double time) { return bend_after(state, mode, j, time).sum; };
  for (double time = scale; time > epsilon * scale; time /= 2)
    if (opens_beyond(noise, time, bend)) return true;
  return false;
}

/// Touching neighbours at rest are pressed in the same instant as contact `from`, and theirs with them,
/// δ ~ t^{7/2} in a row [theory page, "Touching at rest"]. Those that are drawn apart stay open.
template <class Topology>
void press_near(const ContactState<Topology>& state, contact::ContactSet& mode, Index from,
                std::vector<ContactChange>& changes) {
  const auto press = [&](Index j) {
    if (rests(state, mode[j], j) && !is_drawn_apart(state, mode, j))
      change(mode, j, contact::ContactMode::touching, state.model().law[j], changes);
  };
  auto next = changes.size();  // those that are pressed press in turn
  state.topology.for_each_near(from, press);
  for (; next < changes.size(); ++next) state.topology.for_each_near(changes[next].contact, press);
}

/// Tells the changes from `first` on how fast their contacts approach.
template <class Topology>
void tell_approach(const ContactState<Topology>& state, std::size_t first,
                   std::vector<ContactChange>& changes) {
  for (; first < changes.size(); ++first)
    if (auto& one = changes[first]; one.after != contact::ContactMode::touching)
      one.approach = state.approach(one.contact);
}

/// Nothing draws contact j apart that touches at rest: outside forces press it, or a drive may.
template <class Topology>
bool may_be_pressed(const ContactState<Topology>& state, Index j) {
  return state.topology.at.drives() > 0 ? state.drive(j) >= 0 : state.topology.drive(j) > 0;
}

/// Contacts that carry force at 0+: indented ones, touching ones that approach or are driven together, and
/// touching ones at rest that stand near one of these; where a drive may press any, all but those that are
/// drawn apart.
template <class Topology>
void contact_set_at(const ContactState<Topology>& state, contact::ContactSet& mode,
                    std::vector<ContactChange>& changes) {
  using contact::ContactMode;
  reset(mode, state.model().law);
  mode.piece.assign(state.topology.at.drives(), 0);
  const ContactState<Topology> driven{state.topology, state.x, &mode};
  for (Index j = 0; j < state.contacts(); ++j) {
    const double gap = state.gap(j), approach = state.approach(j);
    const auto& law = state.model().law[j];
    const bool slack = gap < 0 && contact::goes_slack(law) && !(state.load(j).value > 0);
    if (slack)
      change(mode, j, ContactMode::slack, law, changes);
    else if (gap < 0 || (gap == 0 && approach > state.topology.rest_speed()))
      change(mode, j, ContactMode::closed, law, changes);
    else if (rests(state, mode[j], j) && may_be_pressed(driven, j))
      change(mode, j, ContactMode::touching, law, changes);
    if (gap < 0 && !mode.memory.empty()) start_indented(mode.memory[j], law, -gap, approach);
  }
  for (Index j = 0; j < state.contacts(); ++j)
    if (contact::carries_force(mode[j])) press_near(state, mode, j, changes);
  tell_approach(state, 0, changes);
  for (auto& one : changes)
    if (state.gap(one.contact) < 0) one.approach = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mariotte::model
