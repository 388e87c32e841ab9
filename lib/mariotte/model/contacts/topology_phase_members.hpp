// The members of TopologyPhase, for the files that instantiate it.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/model/contacts/bound.hpp"
#include "mariotte/model/contacts/creeping.hpp"
#include "mariotte/model/contacts/phase_contact.hpp"
#include "mariotte/model/contacts/topology_phase_guards.hpp"

namespace mariotte::model {

template <class Topology>
void TopologyPhase<Topology>::reset() {
  crossings_.assign(at().guard_contact.size(), flow::Crossing::none);
  levels_.assign(contacts(), 0.0);
  watched_.assign(contacts(), std::nullopt);
  find_magnitudes();
  find_drives();
  flows_.reset(topology_);
}

template <class Topology>
void TopologyPhase<Topology>::find_drives() {
  const auto placed = [&](ContactDirection terms) {
    for (auto& term : terms) term.dof = at().velocity[term.dof];
    return terms;
  };
  driver_.assign(at().size, ContactLayout::absent);
  drives_.clock = at().clock;
  drives_.drive.clear();
  for (Index k = 0; k < at().drives(); ++k) {
    const auto& drive = topology_.model.drive[k];
    drives_.drive.push_back({.direction = placed(drive.direction),
                             .response = placed(drive.response),
                             .is_force = drive.is_force,
                             .change = {},
                             .end = infinity,
                             .guard = at().kink_guard(k),
                             .work = at().drive_work[k]});
    for (const auto& term : drives_.drive.back().direction)
      if (!drive.is_force) driver_[term.dof] = k;
  }
}

template <class Topology>
void TopologyPhase<Topology>::find_magnitudes() {
  const auto& d = topology_.model;
  auto& size = magnitudes_;
  size.assign(at().size, 0.0);
  for (Index j = 0; j < contacts(); ++j) {
    const double momentum = d.reduced_mass[j] * d.speed;
    size[at().gap[j]] = d.length[j];
    if (has_work(j)) size[at().work[j]] = momentum * d.speed;
    if (has_impulse(j)) size[at().impulse[j]] = momentum;
    // A heavy body changes its velocity little: what its light neighbour can do to it.
    topology_.for_each_push(j, [&](Index place, double change) {
      size[place] = std::max(size[place], std::min(d.speed, 2 * momentum * std::abs(change)));
    });
  }
  for (const Index place : at().velocity)
    if (size[place] == 0) size[place] = d.speed;
  for (const Index place : at().drive_work) size[place] = d.speed * d.speed;
  if (at().drives() > 0) size[at().clock] = *std::min_element(d.time.begin(), d.time.end());
}

template <class Topology>
void TopologyPhase<Topology>::bind(contact::ContactSet& mode, bool ends_bound) {
  mode_ = &mode;
  ends_bound_ = ends_bound && at().drives() == 0;
  needs_field_ = false;
  for (Index j = 0; j < contacts(); ++j) {
    const bool remembers = !power_law(law(j));
    if (remembers || watched_[j] != mode[j]) watch(j);
    if (remembers) needs_field_ |= !follow_branch(j);
  }
  count_active();
  for (Index k = 0; k < at().drives(); ++k) {
    auto& drive = drives_.drive[k];
    drive.change = piece(topology_.model.drive[k].change, k);
    drive.end = next_kink(k);
    crossings_[drive.guard] = drive.end < infinity ? flow::Crossing::rising : flow::Crossing::none;
  }
}

template <class Topology>
void TopologyPhase<Topology>::count_active() {
  active_ = 0;
  double shortest = infinity, any = infinity;
  for (Index j = 0; j < contacts(); ++j) {
    const double time = topology_.model.time[j];
    any = std::min(any, time);
    if (!contact::carries_force((*mode_)[j])) continue;
    ++active_;
    shortest = std::min(shortest, time);
  }
  time_scale_ = active_ == 0 ? any : shortest;
}

/// Tells the flows of the branch of contact j, unless it is open; false if it, or a law without branches, is
/// none that they follow.
template <class Topology>
bool TopologyPhase<Topology>::follow_branch(Index j) {
  auto& contact = flows_.contact(j);
  const auto* branches = contact::branched(law(j));
  if (!branches) return contact.role == flow::Role::open || contact.stiffness > 0 || contact.curve;
  contact.origin = contact.damping = contact.pull = contact.ring = 0;
  contact.branch_guard = -1;
  contact.width = nullptr;
  if (contact.role == flow::Role::open) return true;
  widths_.resize(contacts());
  if (!take_over(*branches, past(j), widths_[j], contact)) return false;
  contact.branch_guard = at().branch_guard[j];
  return true;
}

template <class Topology>
void TopologyPhase<Topology>::watch(Index j) {
  const auto mode = (*mode_)[j];
  watched_[j] = mode;
  auto& contact = flows_.contact(j);
  contact.role = role(mode);
  contact.level = levels_[j] = model::level(mode, law(j), past(j), topology_.model.noise_depth[j]);
  const auto [gap, load, yield, turn] = watched(mode, law(j), past(j));
  crossings_[j] = gap;
  if (goes_slack(j)) crossings_[at().load_guard[j]] = load;
  if (!watches_turns(j)) return;
  crossings_[at().branch_guard[j]] = yield;
  crossings_[at().branch_guard[j] + 1] = turn;
  contact.yields =
      yield == flow::Crossing::none ? infinity : contact::branched(law(j))->yield_indentation(past(j));
  contact.turn_side = -static_cast<double>(turn);
  contact.turn_speed = topology_.model.noise_speed;
}

/// Of contact j; a branch that is a power is asked for nothing else.
template <class Topology>
contact::Force TopologyPhase<Topology>::force(double indentation, double rate, Index j) const {
  const auto& c = flows_.contact(j);
  if (c.branch_guard < 0 || c.width || c.ring > 0)
    return force_in((*mode_)[j], law(j), indentation, rate, past(j));
  const contact::PowerLaw power{.stiffness = c.stiffness, .damping = c.damping, .exponent = c.exponent};
  const double depth = indentation - c.origin;
  if (c.role != flow::Role::closed) return contact::force(power, depth, rate);
  auto f = smooth_force(power, depth, rate);
  f.value -= c.pull;
  return f;
}

template <class Topology>
void TopologyPhase<Topology>::derivative(ConstState x, State dx) const {
  std::fill(dx.begin(), dx.end(), 0.0);
  for (Index i = 0; i < velocities(); ++i) dx[at().velocity[i]] = topology_.acceleration(i);
  for (Index j = 0; j < contacts(); ++j) {
    const double rate = topology_.approach(x, j);
    dx[at().gap[j]] = -rate;
    if (!contact::carries_force((*mode_)[j])) continue;
    const double f = force(-x[at().gap[j]], rate, j).value;
    if (has_impulse(j)) dx[at().impulse[j]] = f;
    if (has_work(j)) dx[at().work[j]] = f * rate;
    topology_.for_each_push(j, [&](Index place, double change) { dx[place] += change * f; });
  }
  if (at().drives() > 0) drive(x, dx);
}

/// When the next piece of a drive's signal begins.
template <class Topology>
double TopologyPhase<Topology>::next_kink(Index k) const {
  const auto& pieces = topology_.model.drive[k].signal.piece;
  const auto next = static_cast<std::size_t>((*mode_).piece[k]) + 1;
  return next < pieces.size() ? pieces[next].start : infinity;
}

/// use(k, j, place, g) for each term g of contact j in a velocity that drive k prescribes.
template <class Topology>
template <class Use>
void TopologyPhase<Topology>::for_each_given(Use&& use) const {
  for (Index j = 0; j < contacts(); ++j)
    topology_.for_each_direction(j, [&](Index place, double g) {
      if (driver_[place] != ContactLayout::absent) use(driver_[place], j, place, g);
    });
}

/// Prescribed velocities change as they shall and their walls work against the forces of their contacts;
/// given forces push, and work.
template <class Topology>
void TopologyPhase<Topology>::drive(ConstState x, State dx) const {
  const double time = x[at().clock];
  dx[at().clock] = 1;
  for (Index k = 0; k < at().drives(); ++k) {
    const auto& drive = topology_.model.drive[k];
    const double change = value(piece(drive.change, k), time);
    for (const auto& [dof, coefficient] : drive.response) dx[at().velocity[dof]] += coefficient * change;
    if (drive.is_force)
      for (const auto& [dof, coefficient] : drive.direction)
        dx[at().drive_work[k]] += coefficient * change * x[at().velocity[dof]];
  }
  for_each_given([&](Index k, Index j, Index place, double g) {
    dx[at().drive_work[k]] -= g * x[place] * force(x, j).value;
  });
}

template <class Topology>
void TopologyPhase<Topology>::second_derivative(ConstState, State ddx) const {
  std::fill(ddx.begin(), ddx.end(), 0.0);
  for (Index j = 0; j < contacts(); ++j) ddx[at().gap[j]] = -topology_.drive(j);
}

template <class Topology>
std::vector<flow::Entry> TopologyPhase<Topology>::pattern() const {
  std::vector<flow::Entry> pattern;
  for (Index j = 0; j < contacts(); ++j) {
    const Index gap = at().gap[j];
    const auto velocities_of = [&](Index row) {
      topology_.for_each_direction(j, [&](Index place, double) { pattern.push_back({row, place}); });
    };
    const auto force_on = [&](Index row) {
      pattern.push_back({row, gap});
      velocities_of(row);
    };
    velocities_of(gap);
    topology_.for_each_push(j, [&](Index place, double) { force_on(place); });
    if (has_impulse(j)) force_on(at().impulse[j]);
    if (has_work(j)) force_on(at().work[j]);
  }
  add_drives(pattern);
  return pattern;
}

/// Places of what drives move and of their work.
template <class Topology>
void TopologyPhase<Topology>::add_drives(std::vector<flow::Entry>& pattern) const {
  const Index clock = at().clock;
  for (Index k = 0; k < at().drives(); ++k) {
    const auto& drive = topology_.model.drive[k];
    const Index work = at().drive_work[k];
    for (const auto& term : drive.response) pattern.push_back({at().velocity[term.dof], clock});
    if (!drive.is_force) continue;
    pattern.push_back({work, clock});
    for (const auto& term : drive.direction) pattern.push_back({work, at().velocity[term.dof]});
  }
  for_each_given([&](Index k, Index j, Index place, double) {
    const Index work = at().drive_work[k];
    pattern.push_back({work, place});
    pattern.push_back({work, at().gap[j]});
    topology_.for_each_direction(j, [&](Index other, double) { pattern.push_back({work, other}); });
  });
}

template <class Topology>
void TopologyPhase<Topology>::jacobian(ConstState x, State values) const {
  std::size_t entry = 0;
  for (Index j = 0; j < contacts(); ++j) {
    const auto f = force(x, j);
    // ∂(factor · f + extra · δ̇) by the gap and by the velocities, with δ̇ = −G v
    const auto row = [&](double factor, double extra) {
      values[entry++] = -factor * f.by_indentation;
      topology_.for_each_direction(
          j, [&](Index, double g) { values[entry++] = -(factor * f.by_rate + extra) * g; });
    };
    topology_.for_each_direction(j, [&](Index, double g) { values[entry++] = g; });
    topology_.for_each_push(j, [&](Index, double change) { row(change, 0); });
    if (has_impulse(j)) row(1, 0);
    if (has_work(j)) row(topology_.approach(x, j), f.value);
  }
  drive_slopes(x, values.subspan(entry));
}

/// In the order of their places.
template <class Topology>
void TopologyPhase<Topology>::drive_slopes(ConstState x, State values) const {
  std::size_t entry = 0;
  for (Index k = 0; k < at().drives(); ++k) {
    const auto& drive = topology_.model.drive[k];
    const double time = x[at().clock], by_time = value(rate(piece(drive.change, k)), time);
    for (const auto& term : drive.response) values[entry++] = term.coefficient * by_time;
    if (!drive.is_force) continue;
    double& by_clock = values[entry++] = 0;
    for (const auto& [dof, coefficient] : drive.direction) {
      by_clock += coefficient * by_time * x[at().velocity[dof]];
      values[entry++] = coefficient * value(piece(drive.change, k), time);
    }
  }
  for_each_given([&](Index, Index j, Index place, double g) {
    const auto f = force(x, j);
    values[entry++] = -g * f.value;
    values[entry++] = g * x[place] * f.by_indentation;
    topology_.for_each_direction(j, [&](Index, double h) { values[entry++] = g * x[place] * f.by_rate * h; });
  });
}

template <class Topology>
double TopologyPhase<Topology>::damping_group() const {
  double largest = 0;
  for (Index j = 0; j < contacts(); ++j)
    if (has_work(j) && contact::carries_force((*mode_)[j]))
      largest = std::max(largest, model::damping_group(topology_.model, j));
  return largest;
}

/// All closed contacts adhere, have come to rest and never open again. Overdamped ones creep there, and no
/// turn of their rate tells.
template <class Topology>
bool TopologyPhase<Topology>::is_held(ConstState x) const {
  for (Index j = 0; j < contacts(); ++j)
    if (contact::carries_force((*mode_)[j]) &&
        (!contact::adheres(law(j)) || std::abs(approach(x, j)) > topology_.model.noise_speed))
      return false;
  return is_bound(held_together(ContactState<Topology>{topology_, x, mode_}, *mode_));
}

template <class Topology>
flow::Accepted TopologyPhase<Topology>::accept(ConstState x) {
  using contact::ContactMode;
  auto accepted = flow::Accepted::unchanged;
  const ContactState<Topology> state{topology_, x, mode_};
  CreepingForces<Topology> forces(state, *mode_);
  for (Index j = 0; j < contacts(); ++j) {
    auto& mode = (*mode_)[j];
    if (mode == ContactMode::closed && (has_faded(state, j) || has_let_go(forces, j)))
      return flow::Accepted::ended;
    if (mode == ContactMode::slack && has_passed(forces, j)) return flow::Accepted::ended;
    if (mode != ContactMode::touching) continue;
    if (has_parted(state, j)) return flow::Accepted::ended;
    if (!has_loaded(state, j)) continue;
    mode = ContactMode::closed;
    if (flows_.is_at_edge(j)) return flow::Accepted::ended;
    watch(j);
    accepted = flow::Accepted::rewatched;
  }
  if (ends_bound_ && active_ > 0 && is_held(x)) return flow::Accepted::ended;
  return accepted;
}

}  // namespace mariotte::model
