// Friction in the table of modes: how a contact begins to stick or slip, and what ends either.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "mariotte/core/error.hpp"
#include "mariotte/model/bodies/bodies_system.hpp"
#include "mariotte/model/fault.hpp"

namespace mariotte::model {
namespace {

/// Share of the cap below which what sticks goes on to stick, whatever a guard has said.
constexpr double certain = 0.999;

}  // namespace

/// By leading terms: whether T grows more slowly than its cap. Both are compared shortly after the onset.
template <int D>
bool BodiesSystem<D>::starts_in_stick(const SettingContact<D>& one, const contact::Memory& past,
                                      const ContactMotion<double, D>& now) const {
  const double later = soon * one.time, approach = -now.gap_rate, depth = approach * later,
               slip = norm(now.slip);
  const double from = contact::branched(one.law) ? std::max(-now.gap, closing_depth(one.law, past)) : 0;
  const double cap = one.tangential.friction * smooth_force(one.law, past, from + depth, approach).value;
  const double grown = one.tangential.law == TangentialLaw::spring
                           ? one.tangential.stiffness * slip * later
                           : 2.0 / 3.0 * one.tangential.stiffness * std::sqrt(depth) * slip * later;
  return grown <= cap;
}

/// Whether a spring whose slip is set up holds instead. One that is pressed again, at depth, tells by how
/// fast it would yield.
template <int D>
bool BodiesSystem<D>::begins_to_stick(const Mode& mode, std::size_t place, Start start, ConstState x) const {
  const auto& one = mode.closed[place];
  if (start == Start::onset)
    return starts_in_stick(setting_.contact[one.contact], one.past, motion(one.contact, x));
  field(mode, x);
  return holds_at_once(mode, place);
}

/// ξ of a spring in the tangent plane; where its stiffness grows, T is kept instead.
template <int D>
void BodiesSystem<D>::put_spring(const ClosedContact& one, const ContactForces<double, D>& now,
                                 const Vec<double, D>& stretch, std::vector<double>& x) const {
  const bool as_force =
      setting_.contact[one.contact].tangential.law == TangentialLaw::mindlin && !one.unloading;
  const auto state = (as_force ? now.spring : 1) * stretch;
  const Index at = layout(x).spring(one.slot);
  if constexpr (D == 2)
    x[at] = dot(state, across(now.motion.normal));
  else
    put(State(x), at, state);
}

/// A contact that has been slack grips where its force is beyond noise, and has pushed for a little time
/// then.
template <int D>
void BodiesSystem<D>::hold_since_grip(const Mode& mode, std::size_t place, std::vector<double>& x) const {
  const auto& one = mode.closed[place];
  const auto now = field(mode, x).contact(place);
  const double rate = field_.force_rate(one, now), longest = setting_.contact[one.contact].time;
  const double held = rate > 0 ? std::clamp(now.normal / rate, 0.0, longest) : 0;
  put_spring(one, now, held * now.motion.slip, x);
}

template <int D>
void BodiesSystem<D>::begin_friction(Mode& mode, std::size_t place, Start start, std::vector<double>& x,
                                     std::vector<Change>& changes) const {
  auto& one = mode.closed[place];
  const auto& c = setting_.contact[one.contact];
  x[layout(x).losses(one.slot)] += held_by_spring(one, x);
  one.friction = Friction::none;
  if (c.tangential.law == TangentialLaw::none) return;
  const auto now = motion(one.contact, x);
  const double slip = norm(now.slip);
  const bool rigid = !c.tangential.has_spring();
  const bool moves = slip > (D == 3 && rigid ? setting_.rest_speed() : 100 * epsilon * setting_.speed);
  if (rigid && !moves) return begin_from_rest(mode, place, x, BodyEvent::slip, changes);
  one.from_rest = false;
  if (moves) slip_along(one, (1 / slip) * now.slip, now.normal, x);
  const bool sticks = !rigid && (!moves || begins_to_stick(mode, place, start, x));
  one.friction = sticks ? Friction::stick : Friction::slip;
  if (sticks) std::fill_n(x.begin() + layout(x).spring(one.slot), BodiesLayout<D>::tangents, 0.0);
  if (sticks && start == Start::grip) hold_since_grip(mode, place, x);
  changes.push_back({one.contact, sticks ? BodyEvent::stick : BodyEvent::slip});
}

template <int D>
void BodiesSystem<D>::slip_along(ClosedContact& one, const Vec<double, D>& direction,
                                 const Vec<double, D>& normal, std::vector<double>& x) const {
  one.friction = Friction::slip;
  if constexpr (D == 2) {
    one.sign = dot(direction, across(normal)) < 0 ? -1 : 1;
    x[layout(x).spring(one.slot)] = 0;
  } else {
    one.start.assign(direction.at.begin(), direction.at.end());
    one.rest.clear();
    put(State(x), layout(x).spring(one.slot), direction);
  }
}

/// In space a rigid slip is measured from where it leaves rest.
template <int D>
void BodiesSystem<D>::begin_at_rest(ClosedContact& one, ConstState x) const {
  one.from_rest = D == 3;
  if (D == 2) return;
  const auto now = motion(one.contact, x);
  const auto left = now.slip - dot(now.slip, now.normal) * now.normal;
  one.rest.assign(left.at.begin(), left.at.end());
}

/// Whether a slip at rest is accelerated along its direction, by more than rounding.
template <int D>
bool BodiesSystem<D>::leaves_rest(const Mode& mode, std::size_t place, ConstState x) const {
  constexpr double rounding = 1000 * epsilon;
  const auto& now = field(mode, x).contact(place);
  const double rate = dot(field_.slip_acceleration(mode.closed[place].contact, now.motion), now.direction);
  return rate > rounding * setting_.speed / setting_.time;
}

/// Slips against the friction that would be needed; in the plane the way it is driven, for where contacts are
/// almost redundant that friction is noise. False if no way leads away from rest.
template <int D>
bool BodiesSystem<D>::slip_from_rest(Mode& mode, std::size_t place, const ContactForces<double, D>& held,
                                     std::vector<double>& x) const {
  auto& one = mode.closed[place];
  slip_along(one, (-1 / norm(held.friction)) * held.friction, held.motion.normal, x);
  begin_at_rest(one, x);
  if (D == 3 || leaves_rest(mode, place, x)) return true;
  one.sign = -one.sign;
  if (leaves_rest(mode, place, x)) return true;
  one.sign = -one.sign;
  return false;
}

/// A rigid contact whose slip is zero holds if friction can, and else slips.
template <int D>
void BodiesSystem<D>::begin_from_rest(Mode& mode, std::size_t place, std::vector<double>& x,
                                      BodyEvent otherwise, std::vector<Change>& changes) const {
  auto& one = mode.closed[place];
  const auto& c = setting_.contact[one.contact];
  const auto before = one;
  one.friction = Friction::stick;
  const auto now = field(mode, x).contact(place);
  const bool in_doubt = D == 2 && field_.is_redundant();
  const double needed = norm(now.friction), cap = c.tangential.friction * now.normal;
  const bool holds = needed <= cap + setting_.slip_noise * c.force *
                                         (now.normal > 0 ? now.normal / (now.normal + c.force) : 1);
  if ((!holds || in_doubt) && (slip_from_rest(mode, place, now, x) || !holds)) {
    const bool same_way = before.friction == Friction::slip && before.sign == one.sign;
    if (D == 3 || !same_way) changes.push_back({one.contact, otherwise});
    return;
  }
  one.friction = Friction::stick;
  one.from_rest = false;
  arrest(mode, x);
  changes.push_back({one.contact, BodyEvent::stick});
}

/// A slip ends within the rounding of its root. What is left of it would last as long as the contact sticks:
/// friction takes it away at once, as it would have done a moment later.
template <int D>
void BodiesSystem<D>::arrest(const Mode& mode, std::vector<double>& x) const {
  const auto at = layout(x);
  const auto push = [&](Index body, const Vec<double, D>& lever, const Vec<double, D>& impulse) {
    const auto& one = setting_.body[body];
    const auto turn = moment(lever, impulse);
    for (int k = 0; k < D; ++k) x[at.velocity(body) + k] += impulse[k] / one.mass;
    for (int k = 0; k < turns(D); ++k)
      x[at.momentum(body) + k] += D == 2 ? turn[k] / one.inertia[k] : turn[k];
  };
  field(mode, x);
  const auto& impulses = field_.stopping([&](Index contact) { return motion(contact, x).slip; });
  for (std::size_t k = 0; k < impulses.size(); ++k) {
    const auto& [place, contact] = field_.stuck()[k];
    const auto& one = setting_.contact[contact];
    const auto& now = field_.contact(place).motion;
    push(setting_.sphere[one.b].body, now.lever_b, impulses[k]);
    if (one.plane < 0) push(setting_.sphere[one.a].body, now.lever_a, -1.0 * impulses[k]);
    const Index slot = mode.closed[place].slot;
    if constexpr (D == 2)
      x[at.tangential(slot)] += dot(impulses[k], across(now.normal));
    else
      for (int i = 0; i < D; ++i) x[at.tangential(slot) + i] += impulses[k][i];
    x[at.losses(slot)] -= 0.5 * dot(impulses[k], now.slip);
  }
}

/// Whether a spring that slips would have to be pulled back to go on, by the field that was asked for last:
/// it sticks.
template <int D>
bool BodiesSystem<D>::holds_at_once(const Mode& mode, std::size_t place) const {
  return field_.yielding(mode.closed[place], field_.contact(place)) <
         -0.5 * setting_.slip_noise * setting_.speed;
}

template <int D>
bool BodiesSystem<D>::is_yielding(const ClosedContact& one) const {
  return one.friction == Friction::slip && !one.slack &&
         setting_.contact[one.contact].tangential.has_spring();
}

/// A spring that slips as before, in one of these `slots`, may hold at once: where another contact closes
/// with a damper, forces and so the rate of yielding jump, and where a contact turns at hardly any depth, its
/// stiffness grows that quickly.
template <int D>
void BodiesSystem<D>::stop_yielding(const std::vector<Index>& slots, Mode& mode, std::vector<double>& x,
                                    std::vector<Change>& changes) const {
  const auto yielded = [&](Index slot) { return std::find(slots.begin(), slots.end(), slot) != slots.end(); };
  bool known = false;
  for (std::size_t i = 0; i < mode.closed.size(); ++i) {
    if (!is_yielding(mode.closed[i]) || !yielded(mode.closed[i].slot)) continue;
    if (!std::exchange(known, true)) field(mode, x);
    if (!holds_at_once(mode, i)) continue;
    pass_friction(mode, i, x, changes);
    known = false;
  }
}

/// What a spring that is beyond its cap, by noise, loses where it slips.
template <int D>
double let_go(const ContactForces<double, D>& now, double friction) {
  const double cap = friction * now.normal;
  return std::max(0.0, 0.5 * (dot(now.friction, now.friction) - cap * cap) / now.spring);
}

/// A spring that holds on beyond its cap, by an error of the flow: its guard would fire again at once.
template <int D>
void BodiesSystem<D>::put_back_to_cap(const ClosedContact& one, const ContactForces<double, D>& now,
                                      std::vector<double>& x) const {
  const double friction = setting_.contact[one.contact].tangential.friction;
  const double share = std::max(0.0, friction * now.normal) / norm(now.friction);
  if (share >= 1) return;
  for (Index k = 0; k < BodiesLayout<D>::tangents; ++k) x[layout(x).spring(one.slot) + k] *= share;
  x[layout(x).losses(one.slot)] += let_go(now, friction);
}

/// What sticks slips where it is at its cap. A loose series may take for a root what is none; and what begins
/// to stick at its cap may be beyond it by rounding, while the cap outgrows it.
template <int D>
void BodiesSystem<D>::break_loose(Mode& mode, std::size_t place, const ContactForces<double, D>& now,
                                  std::vector<double>& x, std::vector<Change>& changes) const {
  auto& one = mode.closed[place];
  const auto& tangential = setting_.contact[one.contact].tangential;
  const double size = norm(now.friction);
  if (size == 0 || size < certain * tangential.friction * now.normal) return;
  const auto stuck = one;
  auto slipping = x;
  slip_along(one, (-1 / size) * now.friction, now.motion.normal, slipping);
  if (tangential.has_spring()) {
    field(mode, slipping);
    if (holds_at_once(mode, place)) {
      one = stuck;
      return put_back_to_cap(one, now, x);
    }
  }
  x = std::move(slipping);
  if (tangential.has_spring()) x[layout(x).losses(one.slot)] += let_go(now, tangential.friction);
  if (!tangential.has_spring()) begin_at_rest(one, x);
  changes.push_back({one.contact, BodyEvent::slip});
}

template <int D>
void BodiesSystem<D>::pass_friction(Mode& mode, std::size_t place, std::vector<double>& x,
                                    std::vector<Change>& changes) const {
  auto& one = mode.closed[place];
  const auto& c = setting_.contact[one.contact];
  const auto now = field(mode, x).contact(place);
  if (one.friction == Friction::stick) return break_loose(mode, place, now, x, changes);
  if (!c.tangential.has_spring()) return begin_from_rest(mode, place, x, BodyEvent::reverse, changes);
  one.friction = Friction::stick;
  put_spring(one, now, (c.tangential.friction * now.normal / now.spring) * now.direction, x);
  changes.push_back({one.contact, BodyEvent::stick});
}

/// Slips that are under way have their own direction.
template <int D>
void BodiesSystem<D>::leave_rest(Mode& mode, ConstState x) const {
  const auto left = [&](const ClosedContact& one) {
    return one.from_rest && norm(motion(one.contact, x).slip) > 2 * setting_.rest_speed();
  };
  for (auto& one : mode.closed)
    if (left(one)) one.from_rest = false;
}

/// Slips that friction does not let leave rest stick.
template <int D>
void BodiesSystem<D>::stay_at_rest(Mode& mode, std::vector<double>& x, std::vector<Change>& changes) const {
  for (std::size_t i = 0; i < mode.closed.size(); ++i)
    if (mode.closed[i].from_rest) begin_from_rest(mode, i, x, BodyEvent::reverse, changes);
}

template <int D>
bool BodiesSystem<D>::sticks_rigidly(const ClosedContact& one) const {
  return one.friction == Friction::stick && !one.slack &&
         !setting_.contact[one.contact].tangential.has_spring();
}

/// Names the contacts and the instant.
template <int D>
std::string BodiesSystem<D>::redundancy(const Mode& mode, ConstState x) const {
  std::string names;
  for (const auto& one : mode.closed) {
    const auto& contact = bodies_.contact[one.contact];
    if (!sticks_rigidly(one)) continue;
    names += (names.empty() ? "" : ", ") + name_of(bodies_, contact.a) + "–" + name_of(bodies_, contact.b);
  }
  std::ostringstream message;
  message << "contacts that stick rigidly are redundant at " << x[layout(x).clock()] << " s (" << names
          << "): how they share friction is indeterminate; give them a tangential law 'spring' or 'mindlin'";
  return message.str();
}

/// What sticks rigidly may not hold any more when others have changed: the contact that is farthest beyond
/// its cap slips first.
template <int D>
void BodiesSystem<D>::hold_or_release(Mode& mode, std::vector<double>& x,
                                      std::vector<Change>& changes) const {
  const auto holds = [&](const ClosedContact& one) { return sticks_rigidly(one); };
  for (std::size_t round = 0; round <= mode.closed.size(); ++round) {
    if (std::none_of(mode.closed.begin(), mode.closed.end(), holds)) return;
    const auto& field = this->field(mode, x);
    std::size_t worst = mode.closed.size();
    double most = 1;
    for (std::size_t i = 0; i < mode.closed.size(); ++i) {
      const auto& c = setting_.contact[mode.closed[i].contact];
      if (!sticks_rigidly(mode.closed[i])) continue;
      const double size = norm(field.contact(i).friction);
      const double cap = c.tangential.friction * field.contact(i).normal + 2 * setting_.slip_noise * c.force;
      if (size > most * cap) most = size / cap, worst = i;
    }
    if (field.is_redundant()) throw Error(redundancy(mode, x), fault::indeterminate);
    if (worst == mode.closed.size()) return;
    slip_from_rest(mode, worst, ContactForces<double, D>(field.contact(worst)), x);
    changes.push_back({mode.closed[worst].contact, BodyEvent::slip});
  }
}

template void BodiesSystem<2>::begin_friction(BodiesMode&, std::size_t, BodiesSystem<2>::Start,
                                              std::vector<double>&, std::vector<BodiesChange>&) const;
template bool BodiesSystem<2>::is_yielding(const ClosedContact&) const;
template void BodiesSystem<2>::stop_yielding(const std::vector<Index>&, BodiesMode&, std::vector<double>&,
                                             std::vector<BodiesChange>&) const;
template void BodiesSystem<2>::pass_friction(BodiesMode&, std::size_t, std::vector<double>&,
                                             std::vector<BodiesChange>&) const;
template void BodiesSystem<2>::leave_rest(BodiesMode&, ConstState) const;
template void BodiesSystem<2>::stay_at_rest(BodiesMode&, std::vector<double>&,
                                            std::vector<BodiesChange>&) const;
template void BodiesSystem<2>::hold_or_release(BodiesMode&, std::vector<double>&,
                                               std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::begin_friction(BodiesMode&, std::size_t, BodiesSystem<3>::Start,
                                              std::vector<double>&, std::vector<BodiesChange>&) const;
template bool BodiesSystem<3>::is_yielding(const ClosedContact&) const;
template void BodiesSystem<3>::stop_yielding(const std::vector<Index>&, BodiesMode&, std::vector<double>&,
                                             std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::pass_friction(BodiesMode&, std::size_t, std::vector<double>&,
                                             std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::leave_rest(BodiesMode&, ConstState) const;
template void BodiesSystem<3>::stay_at_rest(BodiesMode&, std::vector<double>&,
                                            std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::hold_or_release(BodiesMode&, std::vector<double>&,
                                               std::vector<BodiesChange>&) const;

}  // namespace mariotte::model
