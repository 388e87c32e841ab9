// Field and guards of bodies in contact on a tape.
#include <algorithm>
#include <cmath>

#include "mariotte/model/bodies/bodies_flight.hpp"
#include "mariotte/model/bodies/bodies_phase.hpp"
#include "mariotte/model/bodies/near_pairs.hpp"

namespace mariotte::model {

using series::Traced;

/// Natural time of a contact [s] from which on no coefficient of its series overflows: they count in seconds,
/// and those of order k grow like the inverse of that time to the k.
constexpr double shortest = 1e-12;

/// A slip in space comes to rest, or turns ever faster towards the end of its contact, where no series goes.
/// Nor has a series the slip of a Mindlin spring under a linear force: the rate at which it gives way has
/// poles where the contact begins and ends.
template <int D>
bool BodiesPhase<D>::can_be_recorded(const ClosedContact& mode) const {
  const auto& one = setting_.contact[mode.contact];
  const bool slips_in_space = D == 3 && mode.friction == Friction::slip && !mode.slack;
  if (!model::can_be_recorded(one.law, mode.past) || slips_in_space || !(one.time > shortest)) return false;
  const auto power = contact::powers(one.law);
  return one.tangential.law != TangentialLaw::mindlin || (power && power->exponent == 1.5);
}

/// Bodies that touch or may meet others; the rest fly freely.
template <int D>
void BodiesPhase<D>::find_followed() const {
  is_followed_.assign(layout_.bodies, !free_flight_);
  const auto follow = [&](Index contact) {
    const auto& c = setting_.contact[contact];
    for (const Index sphere : {c.a, c.b})
      if (sphere >= 0) is_followed_[setting_.sphere[sphere].body] = 1;
  };
  for (const auto& one : mode_->closed) follow(one.contact);
  for (Index k = 0; k < watched_count(); ++k)
    if (crossing_[gap_guard(k)] != flow::Crossing::none && !is_far_[k]) follow(watched(k));
  followed_.clear();
  const auto add = [&](Index first, Index count) {
    for (Index k = 0; k < count; ++k) followed_.push_back(first + k);
  };
  for (Index i = 0; i < layout_.bodies; ++i)
    if (is_followed_[i]) add(layout_.shift(i), layout_.body_size);
  add(layout_.clock(), 1);
  for (const auto& one : mode_->closed) add(layout_.spring(one.slot), layout_.slot_size);
}

/// Pairs that a few natural indentations do not bring together.
template <int D>
void BodiesPhase<D>::find_far(ConstState x, bool all) const {
  is_far_.assign(watched_count(), 0);
  if (all) return;
  for (Index k = 0; k < watched_count(); ++k)
    is_far_[k] = crossing_[gap_guard(k)] != flow::Crossing::none &&
                 is_far(setting_, layout_, x, setting_.contact[watched(k)]);
}

template <int D>
bool BodiesPhase<D>::stays_far(ConstState x, double time, ConstState moves) const {
  reach_.clear();
  for (Index i = 0; i < layout_.bodies; ++i)
    reach_.push_back(is_followed_[i] ? norm(vec_at<D>(moves, layout_.shift(i)))
                                     : flown(setting_, vec_at<D>(x, layout_.velocity(i)), time));
  for (Index k = 0; k < watched_count(); ++k)
    if (is_far_[k] && !stays_open(setting_, layout_, x, setting_.contact[watched(k)], time,
                                  std::span<const double>(reach_)))
      return false;
  return true;
}

template <int D>
void BodiesPhase<D>::record(ConstState x, double accuracy, bool all, flow::Recording& recording) const {
  auto& tape = recording.tape;
  tape.clear();
  find_far(x, all);
  recording.is_partial = std::find(is_far_.begin(), is_far_.end(), 1) != is_far_.end();
  find_followed();
  recording.component = followed_;
  recording.state.clear();
  traced_x_.assign(x.begin(), x.end());
  for (const Index i : followed_) {
    const int place = tape.put({.op = series::TapeOp::state, .a = static_cast<int>(i)});
    traced_x_[i] = Traced(tape, place, x[i]);
    recording.state.push_back({.place = place});
  }
  release_springs(x);
  traced_dx_.resize(x.size());
  traced_.evaluate(layout_, *mode_, std::span<const Traced>(traced_x_));
  traced_.rates(*mode_, std::span<const Traced>(traced_x_), std::span<Traced>(traced_dx_));
  for (std::size_t i = 0; i < followed_.size(); ++i)
    recording.state[i].rate = traced_dx_[followed_[i]].place_on(tape);
  record_guards(recording);
  record_contacts(accuracy, recording);
}

/// A contact that begins has no friction yet, though it may have closed within the accuracy before.
template <int D>
void BodiesPhase<D>::release_springs(ConstState x) const {
  for (const auto& one : mode_->closed) {
    const auto& contact = setting_.contact[one.contact];
    const auto motion = gap_motion(setting_, layout_, contact, x);
    if (one.friction != Friction::stick || !begins(setting_, contact, motion.gap, motion.gap_rate)) continue;
    for (Index k = 0; k < layout_.tangents; ++k) {
      auto& state = traced_x_[layout_.spring(one.slot) + k];
      state = at_onset(state);
    }
  }
}

template <int D>
void BodiesPhase<D>::record_guards(flow::Recording& recording) const {
  recording.guard.clear();
  traced_values_.resize(guard_count());
  guards_of<Traced>(traced_, traced_values_);
  for (Index i = 0; i < guard_count(); ++i) {
    if (crossing_[i] == flow::Crossing::none || traced_values_[i].is_constant()) continue;
    const double sign = crossing_[i] == flow::Crossing::rising ? -1 : 1;
    recording.guard.push_back({i, traced_values_[i].place_on(recording.tape), sign});
  }
}

namespace {

/// Along e_z × n in the plane; its square in space.
Traced friction_size(const ContactForces<Traced, 2>& c) {
  return dot(c.friction, across(c.motion.normal));
}
Traced friction_size(const ContactForces<Traced, 3>& c) {
  return dot(c.friction, c.friction);
}

/// What a contact still does at a depth δ before it opens is (δ/L)ⁿ⁺¹ of what it can do.
double negligible(const RecordedForce& law, double length, double share) {
  return law.exponent > 0 ? length * std::pow(share, 1 / (law.exponent + 1)) : 0;
}

}  // namespace

template <int D>
void BodiesPhase<D>::record_contacts(double accuracy, flow::Recording& recording) const {
  constexpr double share = 1e-3;
  recording.contact.clear();
  for (std::size_t i = 0; i < mode_->closed.size(); ++i) {
    const auto& one = setting_.contact[mode_->closed[i].contact];
    const auto& now = traced_.contact(i);
    const auto law = traced_.recorded(mode_->closed[i], one, now.motion.indentation, -now.motion.gap_rate);
    const int place = law.left.place_on(recording.tape);
    recording.contact.push_back({.depth = now.motion.indentation.place_on(recording.tape),
                                 .left = place,
                                 .root = law.root ? law.root->place_on(recording.tape) : -1,
                                 .open = slot_guard(mode_->closed[i].slot, SlotGuard::open),
                                 .normal = now.normal.place_on(recording.tape),
                                 .friction = friction_size(now).place_on(recording.tape),
                                 .is_square = D == 3,
                                 .begins = recording.tape[place].op == series::TapeOp::onset,
                                 .negligible = negligible(law, one.length, share * accuracy)});
  }
}

template <int D>
void BodiesPhase<D>::fly_others(ConstState x, double t, State result) const {
  for (Index i = 0; i < layout_.bodies; ++i)
    if (!is_followed_[i]) model::fly(setting_, layout_, x, i, t, result);
}

template void BodiesPhase<2>::record(ConstState, double, bool, flow::Recording&) const;
template void BodiesPhase<3>::record(ConstState, double, bool, flow::Recording&) const;
template bool BodiesPhase<2>::stays_far(ConstState, double, ConstState) const;
template bool BodiesPhase<3>::stays_far(ConstState, double, ConstState) const;
template void BodiesPhase<2>::fly_others(ConstState, double, State) const;
template void BodiesPhase<3>::fly_others(ConstState, double, State) const;
template bool BodiesPhase<2>::can_be_recorded(const ClosedContact&) const;
template bool BodiesPhase<3>::can_be_recorded(const ClosedContact&) const;

}  // namespace mariotte::model
