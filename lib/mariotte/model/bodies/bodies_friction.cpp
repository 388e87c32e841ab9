// Friction in the table of modes: how a contact begins to stick or slip, and what ends either.
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/model/bodies/bodies_system.hpp"
#include "mariotte/model/fault.hpp"

namespace mariotte::model {
namespace {

/// Share of the cap below which what sticks goes on to stick, whatever a guard has said.
constexpr double certain = 0.999;

}  // namespace

/// By leading terms: whether T grows more slowly than its cap. Both are compared shortly after the start, or
/// after an adhesive contact begins to push.
template <int D>
bool BodiesSystem<D>::starts_in_stick(const SettingContact<D>& one, const contact::Memory& past,
                                      const ContactMotion<double, D>& now) const {
  const double soon = 1e-10 * one.time, approach = -now.gap_rate, depth = approach * soon,
               slip = norm(now.slip);
  const double from = contact::branched(one.law) ? -now.gap : 0;
  const double cap = one.tangential.friction * smooth_force(one.law, past, from + depth, approach).value;
  const double grown = one.tangential.law == TangentialLaw::spring
                           ? one.tangential.stiffness * slip * soon
                           : 2.0 / 3.0 * one.tangential.stiffness * std::sqrt(depth) * slip * soon;
  return grown <= cap;
}

template <int D>
void BodiesSystem<D>::begin_friction(Mode& mode, std::size_t place, std::vector<double>& x,
                                     std::vector<Change>& changes) const {
  auto& one = mode.closed[place];
  const auto& c = setting_.contact[one.contact];
  one.friction = Friction::none;
  if (c.tangential.law == TangentialLaw::none) return;
  const auto now = motion(one.contact, x);
  const double slip = norm(now.slip);
  const bool moves = slip > 100 * epsilon * setting_.speed;
  if (!c.tangential.has_spring() && !moves) return begin_from_rest(mode, place, x, BodyEvent::slip, changes);
  const bool sticks = c.tangential.has_spring() && (!moves || starts_in_stick(c, one.past, now));
  one.friction = sticks ? Friction::stick : Friction::slip;
  one.from_rest = false;
  if (sticks)
    std::fill_n(x.begin() + layout(x).spring(one.slot), BodiesLayout<D>::tangents, 0.0);
  else
    slip_along(one, (1 / slip) * now.slip, now.normal, x);
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
    put(State(x), layout(x).spring(one.slot), direction);
  }
}

/// A rigid contact whose slip is zero holds if friction can, and else slips against the friction it would
/// need.
template <int D>
void BodiesSystem<D>::begin_from_rest(Mode& mode, std::size_t place, std::vector<double>& x,
                                      BodyEvent otherwise, std::vector<Change>& changes) const {
  auto& one = mode.closed[place];
  const auto& c = setting_.contact[one.contact];
  const auto before = one;
  one.friction = Friction::stick;
  const auto& now = field(mode, x).contact(place);
  const double needed = norm(now.friction), cap = c.tangential.friction * now.normal;
  if (needed <=
      cap + setting_.slip_noise * c.force * (now.normal > 0 ? now.normal / (now.normal + c.force) : 1)) {
    one.from_rest = false;
    changes.push_back({one.contact, BodyEvent::stick});
    return;
  }
  const auto normal = now.motion.normal;
  slip_along(one, (-1 / needed) * now.friction, normal, x);
  one.from_rest = D == 3;
  const bool same_way = before.friction == Friction::slip && before.sign == one.sign;
  if (D == 3 || !same_way) changes.push_back({one.contact, otherwise});
}

/// A spring that slipped `before` may hold at once: where another contact closes with a damper, forces and so
/// the rate of yielding jump, and where a contact turns at hardly any depth, its stiffness grows that
/// quickly.
template <int D>
void BodiesSystem<D>::stop_yielding(const std::vector<ClosedContact>& before, Mode& mode,
                                    std::vector<double>& x, std::vector<Change>& changes) const {
  const auto slips = [&](const ClosedContact& one) {
    return one.friction == Friction::slip && !one.slack &&
           setting_.contact[one.contact].tangential.has_spring();
  };
  for (std::size_t i = 0; i < mode.closed.size(); ++i) {
    const auto& one = mode.closed[i];
    const auto same = [&](const ClosedContact& other) { return other.slot == one.slot && slips(other); };
    if (!slips(one) || std::none_of(before.begin(), before.end(), same)) continue;
    const auto& now = field(mode, x);
    if (now.yielding(one, now.contact(i)) < -setting_.slip_noise * setting_.speed)
      pass_friction(mode, i, x, changes);
  }
}

template <int D>
void BodiesSystem<D>::pass_friction(Mode& mode, std::size_t place, std::vector<double>& x,
                                    std::vector<Change>& changes) const {
  auto& one = mode.closed[place];
  const auto& c = setting_.contact[one.contact];
  const auto now = field(mode, x).contact(place);
  if (one.friction == Friction::stick) {
    const double size = norm(now.friction);
    // A loose series may take for a root what is none.
    if (size == 0 || size < certain * c.tangential.friction * now.normal) return;
    slip_along(one, (-1 / size) * now.friction, now.motion.normal, x);
    one.from_rest = D == 3 && !c.tangential.has_spring();
    changes.push_back({one.contact, BodyEvent::slip});
    return;
  }
  if (!c.tangential.has_spring()) return begin_from_rest(mode, place, x, BodyEvent::reverse, changes);
  one.friction = Friction::stick;
  const bool as_force = c.tangential.law == TangentialLaw::mindlin && !one.unloading;
  const auto state = (c.tangential.friction * now.normal / (as_force ? 1 : now.spring)) * now.direction;
  const Index at = layout(x).spring(one.slot);
  if constexpr (D == 2)
    x[at] = dot(state, across(now.motion.normal));
  else
    put(State(x), at, state);
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

/// What sticks rigidly may not hold any more when others have changed: the contact that is farthest beyond
/// its cap slips first.
template <int D>
void BodiesSystem<D>::hold_or_release(Mode& mode, std::vector<double>& x,
                                      std::vector<Change>& changes) const {
  const auto holds = [&](const ClosedContact& one) {
    return one.friction == Friction::stick && !one.slack &&
           !setting_.contact[one.contact].tangential.has_spring();
  };
  for (std::size_t round = 0; round <= mode.closed.size(); ++round) {
    if (std::none_of(mode.closed.begin(), mode.closed.end(), holds)) return;
    const auto& field = this->field(mode, x);
    std::size_t worst = mode.closed.size();
    double most = 1;
    for (std::size_t i = 0; i < mode.closed.size(); ++i) {
      const auto& c = setting_.contact[mode.closed[i].contact];
      if (!holds(mode.closed[i])) continue;
      const double size = norm(field.contact(i).friction);
      const double cap = c.tangential.friction * field.contact(i).normal + 2 * setting_.slip_noise * c.force;
      if (size > most * cap) most = size / cap, worst = i;
    }
    if (field.is_redundant())
      throw Error(
          "contacts that stick rigidly are redundant: how they share friction is indeterminate; give "
          "them a tangential law 'spring' or 'mindlin'",
          fault::indeterminate);
    if (worst == mode.closed.size()) return;
    auto& one = mode.closed[worst];
    const auto now = field.contact(worst);
    slip_along(one, (-1 / norm(now.friction)) * now.friction, now.motion.normal, x);
    one.from_rest = D == 3;
    changes.push_back({one.contact, BodyEvent::slip});
  }
}

template void BodiesSystem<2>::begin_friction(BodiesMode&, std::size_t, std::vector<double>&,
                                              std::vector<BodiesChange>&) const;
template void BodiesSystem<2>::stop_yielding(const std::vector<ClosedContact>&, BodiesMode&,
                                             std::vector<double>&, std::vector<BodiesChange>&) const;
template void BodiesSystem<2>::pass_friction(BodiesMode&, std::size_t, std::vector<double>&,
                                             std::vector<BodiesChange>&) const;
template void BodiesSystem<2>::leave_rest(BodiesMode&, ConstState) const;
template void BodiesSystem<2>::stay_at_rest(BodiesMode&, std::vector<double>&,
                                            std::vector<BodiesChange>&) const;
template void BodiesSystem<2>::hold_or_release(BodiesMode&, std::vector<double>&,
                                               std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::begin_friction(BodiesMode&, std::size_t, std::vector<double>&,
                                              std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::stop_yielding(const std::vector<ClosedContact>&, BodiesMode&,
                                             std::vector<double>&, std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::pass_friction(BodiesMode&, std::size_t, std::vector<double>&,
                                             std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::leave_rest(BodiesMode&, ConstState) const;
template void BodiesSystem<3>::stay_at_rest(BodiesMode&, std::vector<double>&,
                                            std::vector<BodiesChange>&) const;
template void BodiesSystem<3>::hold_or_release(BodiesMode&, std::vector<double>&,
                                               std::vector<BodiesChange>&) const;

}  // namespace mariotte::model
