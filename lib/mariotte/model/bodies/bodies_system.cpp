#include "mariotte/model/bodies/bodies_system.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/model/bodies/near_pairs.hpp"
#include "mariotte/model/fault.hpp"

namespace mariotte::model {
namespace {

template <int D>
Index resting_contacts(const BodiesSetting<D>& setting) {
  return std::count_if(setting.contact.begin(), setting.contact.end(),
                       [](const auto& c) { return c.gap == 0; });
}

/// Share of the cap below which what sticks goes on to stick, whatever a guard has said.
constexpr double certain = 0.999;

/// Slots that are made at once; more are added when so many contacts are closed together.
constexpr Index first_slots = 12;

}  // namespace

template <int D>
BodiesSystem<D>::BodiesSystem(const Bodies& bodies, double accuracy, Over over)
    : setting_(setting_of<D>(bodies, accuracy)),
      over_(over),
      field_(setting_),
      phase_(setting_, resting_contacts(setting_)) {}

template <int D>
BodiesLayout<D> BodiesSystem<D>::layout(ConstState x) const {
  BodiesLayout<D> at{.bodies = std::ssize(setting_.body), .slots = 0};
  at.slots = (std::ssize(x) - at.size()) / at.slot_size;
  return at;
}

template <int D>
const BodiesField<double, D>& BodiesSystem<D>::field(const Mode& mode, ConstState x) const {
  field_.evaluate(layout(x), mode, x);
  return field_;
}

template <int D>
BodiesPhase<D>& BodiesSystem<D>::problem(const Mode& mode) {
  phase_.bind(mode);
  return phase_;
}

template <int D>
void BodiesSystem<D>::mode_at(std::vector<double>& x, Mode& mode, std::vector<Change>& changes) const {
  mode = {};
  mode.totals.resize(setting_.contact.size());
  for (auto& totals : mode.totals) totals.tangential.assign(BodiesLayout<D>::tangents, 0.0);
  const double noise = 16 * epsilon * setting_.speed;
  std::vector<Index> closing;
  for (Index c = 0; c < std::ssize(setting_.contact); ++c) {
    if (setting_.contact[c].gap > 0) continue;
    const double rate = field(mode, x).motion(c).gap_rate;
    if (rate < -noise)
      closing.push_back(c);
    else if (rate <= noise)
      mode.touching.push_back(c);
  }
  for (const Index c : closing) close(mode, c, x, BodyEvent::close, changes);
  leave_rest(mode, x);
  hold_or_release(mode, x, changes);
  refresh_near(setting_, layout(x), x, mode);
}

template <int D>
void BodiesSystem<D>::close(Mode& mode, Index contact, std::vector<double>& x, BodyEvent event,
                            std::vector<Change>& changes) const {
  auto at = layout(x);
  if (mode.idle.empty()) {
    const Index most = std::ssize(setting_.contact);
    const Index slots = std::min(most, std::max(first_slots, 2 * at.slots));
    for (Index s = slots; s-- > at.slots;) mode.idle.push_back(s);
    at.slots = slots;
    x.resize(at.size(), 0.0);
  }
  ClosedContact one{.contact = contact, .slot = mode.idle.back(), .start = {}};
  mode.idle.pop_back();
  std::fill_n(x.begin() + at.spring(one.slot), at.slot_size, 0.0);
  const auto place = std::lower_bound(mode.closed.begin(), mode.closed.end(), contact,
                                      [](const ClosedContact& c, Index i) { return c.contact < i; });
  const std::size_t index = place - mode.closed.begin();
  mode.closed.insert(place, one);
  const double approach = event == BodyEvent::close ? -field(mode, x).motion(contact).gap_rate : 0;
  changes.push_back({contact, event, approach});
  begin_friction(mode, index, x, changes);
}

template <int D>
void BodiesSystem<D>::open(Mode& mode, std::size_t place, std::vector<double>& x,
                           std::vector<Change>& changes) const {
  const auto one = mode.closed[place];
  const auto at = layout(x);
  const double approach = -field(mode, x).motion(one.contact).gap_rate;
  auto& totals = mode.totals[one.contact];
  totals.normal += x[at.normal(one.slot)];
  for (Index k = 0; k < at.tangents; ++k) totals.tangential[k] += x[at.tangential(one.slot) + k];
  const double* loss = &x[at.losses(one.slot)];
  totals.friction += loss[0];
  totals.rescale += loss[1];
  totals.damper += loss[2];
  std::fill_n(x.begin() + at.spring(one.slot), at.slot_size, 0.0);
  mode.idle.push_back(one.slot);
  mode.closed.erase(mode.closed.begin() + static_cast<Index>(place));
  changes.push_back({one.contact, BodyEvent::open, approach});
}

/// By leading terms: whether T grows more slowly than its cap. Both are compared shortly after the start.
template <int D>
bool BodiesSystem<D>::starts_in_stick(const SettingContact<D>& one, double slip, double approach) const {
  const double soon = 1e-10 * one.time, depth = approach * soon;
  const double cap = one.tangential.friction * contact::smooth_force(one.law, depth, approach).value;
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
  const auto now = field(mode, x).motion(one.contact);
  const double slip = norm(now.slip);
  const bool moves = slip > 100 * epsilon * setting_.speed;
  if (!c.tangential.has_spring() && !moves) return begin_from_rest(mode, place, x, BodyEvent::slip, changes);
  const bool sticks = c.tangential.has_spring() && (!moves || starts_in_stick(c, slip, -now.gap_rate));
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

template <int D>
void BodiesSystem<D>::turn(ClosedContact& one, const ContactForces<double, D>& now, std::vector<double>& x,
                           std::vector<Change>& changes) const {
  const bool mindlin = setting_.contact[one.contact].tangential.law == TangentialLaw::mindlin;
  one.unloading = !one.unloading;
  changes.push_back({one.contact, one.unloading ? BodyEvent::unload : BodyEvent::load});
  if (!mindlin || one.friction != Friction::stick || one.slack) return;
  const double factor = one.unloading ? 1 / now.spring : now.spring;  // T to ξ, or back
  for (Index k = 0; k < BodiesLayout<D>::tangents; ++k) x[layout(x).spring(one.slot) + k] *= factor;
}

/// Contacts that part beyond gap 0, where another guard has fired within rounding of their end.
template <int D>
void BodiesSystem<D>::open_parted(Mode& mode, std::vector<double>& x, std::vector<Change>& changes) const {
  for (std::size_t i = mode.closed.size(); i-- > 0;) {
    const auto now = field(mode, x).motion(mode.closed[i].contact);
    if (now.gap >= 0 && now.gap_rate > setting_.slip_noise * setting_.speed) open(mode, i, x, changes);
  }
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

template <int D>
void BodiesSystem<D>::pass_slot(SlotGuard guard, Mode& mode, std::size_t place, std::vector<double>& x,
                                std::vector<Change>& changes) const {
  auto& one = mode.closed[place];
  switch (guard) {
    case SlotGuard::open:
      return open(mode, place, x, changes);
    case SlotGuard::friction:
      return pass_friction(mode, place, x, changes);
    case SlotGuard::turn:
      return turn(one, field(mode, x).contact(place), x, changes);
    case SlotGuard::load:
      one.slack = !one.slack;
      changes.push_back({one.contact, one.slack ? BodyEvent::slack : BodyEvent::grip});
      if (!one.slack) begin_friction(mode, place, x, changes);
  }
}

template <int D>
void BodiesSystem<D>::transition(Mode& mode, const std::vector<Index>& fired, std::vector<double>& x,
                                 std::vector<Change>& changes) const {
  const Index gaps = phase_.gap_guard(0), partings = phase_.parting_guard(0), strays = phase_.stray_guard(0);
  const auto touching = mode.touching;
  auto sorted = fired;
  std::sort(sorted.begin(), sorted.end());
  const auto before = mode.closed;
  for (const Index guard : sorted) {
    if (guard >= strays) {
      mode.from.clear();
    } else if (guard >= partings) {
      const Index contact = touching[guard - partings];
      std::erase(mode.touching, contact);
      changes.push_back({contact, BodyEvent::touch});
      changes.push_back({contact, BodyEvent::part});
    } else if (guard >= gaps) {
      const Index contact = phase_.watched(guard - gaps);
      const bool rested = std::erase(mode.touching, contact) > 0;
      close(mode, contact, x, rested ? BodyEvent::touch : BodyEvent::close, changes);
    } else {
      const Index slot = guard / guards_per_slot;
      const auto one = std::find_if(mode.closed.begin(), mode.closed.end(),
                                    [&](const ClosedContact& c) { return c.slot == slot; });
      if (one != mode.closed.end())
        pass_slot(static_cast<SlotGuard>(guard % guards_per_slot), mode, one - mode.closed.begin(), x,
                  changes);
    }
  }
  open_parted(mode, x, changes);
  stop_yielding(before, mode, x, changes);
  leave_rest(mode, x);
  if (fired.empty()) stay_at_rest(mode, x, changes);
  hold_or_release(mode, x, changes);
  refresh_near(setting_, layout(x), x, mode);
}

/// Slips that are under way have their own direction.
template <int D>
void BodiesSystem<D>::leave_rest(Mode& mode, ConstState x) const {
  const auto left = [&](const ClosedContact& one) {
    return one.from_rest && norm(field(mode, x).motion(one.contact).slip) > 2 * setting_.rest_speed();
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
  for (std::size_t round = 0; round <= mode.closed.size(); ++round) {
    const auto& field = this->field(mode, x);
    std::size_t worst = mode.closed.size();
    double most = 1;
    bool any = false;
    for (std::size_t i = 0; i < mode.closed.size(); ++i) {
      const auto& one = mode.closed[i];
      const auto& c = setting_.contact[one.contact];
      if (one.friction != Friction::stick || one.slack || c.tangential.has_spring()) continue;
      any = true;
      const double size = norm(field.contact(i).friction);
      const double cap = c.tangential.friction * field.contact(i).normal + 2 * setting_.slip_noise * c.force;
      if (size > most * cap) most = size / cap, worst = i;
    }
    if (any && field.is_redundant())
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

template <int D>
bool BodiesSystem<D>::is_over(const Mode& mode, ConstState x, bool) const {
  if (over_ == Over::at_time_limit || !mode.closed.empty()) return false;
  phase_.bind(mode);
  if (!phase_.is_ballistic()) return false;
  std::vector<Index> fired;
  return !(phase_.first_meeting(x, infinity, 0, fired) < infinity);
}

template class BodiesSystem<2>;
template class BodiesSystem<3>;

}  // namespace mariotte::model
