#include "mariotte/model/bodies/bodies_system.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/bodies/bodies_parting.hpp"
#include "mariotte/model/bodies/bodies_rest.hpp"
#include "mariotte/model/bodies/near_pairs.hpp"

namespace mariotte::model {
namespace {

template <int D>
Index resting_contacts(const BodiesSetting<D>& setting) {
  return std::count_if(setting.contact.begin(), setting.contact.end(),
                       [](const auto& c) { return c.gap == 0; });
}

/// What a contact that lets go lets go with: its force where it can pull, else that of its power of δ.
template <int D>
double load_of(const SettingContact<D>& one, const ContactForces<double, D>& now) {
  if (contact::pulls(one.law)) return now.normal;
  return law_load<double>(one, now.motion.indentation, -now.motion.gap_rate);
}

/// Slots that are made at once; more are added when so many contacts are closed together.
constexpr Index first_slots = 12;

}  // namespace

template <int D>
BodiesSystem<D>::BodiesSystem(const Bodies& bodies, BodiesSetting<D> setting, Over over)
    : bodies_(bodies),
      setting_(std::move(setting)),
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
  const bool remembers = std::any_of(setting_.contact.begin(), setting_.contact.end(),
                                     [](const auto& one) { return contact::branched(one.law); });
  mode.memory.assign(remembers ? setting_.contact.size() : 0, {});
  const double noise = 16 * epsilon * setting_.speed;
  std::vector<Index> closing;
  for (Index c = 0; c < std::ssize(setting_.contact); ++c) {
    if (setting_.contact[c].gap > 0) continue;
    const double rate = approach(c, x).gap_rate;
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
  allow_rounding(setting_, lost_share(setting_, at, setting_.contact[contact], ConstState(x)));
  if (mode.idle.empty()) {
    const Index most = std::ssize(setting_.contact);
    const Index slots = std::min(most, std::max(first_slots, 2 * at.slots));
    for (Index s = slots; s-- > at.slots;) mode.idle.push_back(s);
    at.slots = slots;
    x.resize(at.size(), 0.0);
  }
  ClosedContact one{.contact = contact,
                    .slot = mode.idle.back(),
                    .gap_noise = gap_rounding(setting_, at, setting_.contact[contact], x) / 64,
                    .past = memory_of(mode, contact),
                    .start = {}};
  mode.idle.pop_back();
  std::fill_n(x.begin() + at.spring(one.slot), at.slot_size, 0.0);
  const auto place = std::lower_bound(mode.closed.begin(), mode.closed.end(), contact,
                                      [](const ClosedContact& c, Index i) { return c.contact < i; });
  const std::size_t index = place - mode.closed.begin();
  mode.closed.insert(place, one);
  const auto now = approach(contact, x);
  changes.push_back({contact, event, event == BodyEvent::close ? -now.gap_rate : 0});
  begin_branch(mode.closed[index], now);
  sink(mode.closed[index], now, x);
  // What touched at rest is watched once it is out of the noise, and has pushed since before.
  const auto start = event == BodyEvent::touch && now.gap < 0 ? Start::grip : Start::onset;
  if (!mode.closed[index].slack) begin_friction(mode, index, start, x, changes);
}

/// What has no series is followed by CVODE, from a depth on that is more than rounding of its gap: the first
/// steps of a strong damper would not change that. All bodies move on so far, but hardly: where they meet
/// slowly that would take long.
template <int D>
void BodiesSystem<D>::sink(const ClosedContact& one, const GapMotion<double, D>& now,
                           std::vector<double>& x) const {
  const auto at = layout(x);
  if (can_be_recorded(setting_.contact[one.contact].law, one.past) || !(now.gap_rate < 0)) return;
  const double time = std::min(one.gap_noise / -now.gap_rate, soon * setting_.time);
  for (Index i = 0; i < at.bodies; ++i)
    for (int k = 0; k < D; ++k) x[at.shift(i) + k] += time * x[at.velocity(i) + k];
  x[at.clock()] += time;
}

/// One that snaps in pulls at first, and so does one whose pull grows from zero.
template <int D>
void BodiesSystem<D>::begin_branch(ClosedContact& one, const GapMotion<double, D>& now) const {
  const auto& contact = setting_.contact[one.contact];
  const auto* law = contact::branched(contact.law);
  if (!law) return;
  contact::begin(one.past, *law);
  const double approach = std::max(0.0, -now.gap_rate), depth = -now.gap + soon * contact.time * approach;
  one.slack = law->pulls() && law->force(one.past, depth, approach).value < 0;
}

/// What Mindlin's spring still holds where rounding hides the rest of its contact: all of it is lost to the
/// end.
template <int D>
double BodiesSystem<D>::held_at_the_end(const Mode& mode, std::size_t place, ConstState x) const {
  const auto& one = mode.closed[place];
  if (!fades(setting_, one) || one.friction == Friction::none) return 0;
  const auto& now = field(mode, x).contact(place);
  return now.motion.gap < 0 ? 0.5 * dot(now.friction, now.friction) / now.spring : 0;
}

/// What a spring of one stiffness still holds where its contact lets go: it is lost in a slip that was too
/// short to be followed, for its cap falls to zero.
template <int D>
double BodiesSystem<D>::held_by_spring(const ClosedContact& one, ConstState x) const {
  const auto& tangential = setting_.contact[one.contact].tangential;
  if (one.friction != Friction::stick || tangential.law != TangentialLaw::spring) return 0;
  double square = 0;
  for (Index k = 0; k < BodiesLayout<D>::tangents; ++k) {
    const double stretch = x[layout(x).spring(one.slot) + k];
    square += stretch * stretch;
  }
  return 0.5 * tangential.stiffness * square;
}

/// What a spring holds at its cap where the load of its contact vanishes at the instant at which it slips.
template <int D>
double BodiesSystem<D>::held_at_the_cap(const Mode& mode, std::size_t place, ConstState x) const {
  const auto& one = mode.closed[place];
  if (!is_yielding(one)) return 0;
  const auto& now = field(mode, x).contact(place);
  return now.normal > 0 && now.spring > 0 ? 0.5 * dot(now.friction, now.friction) / now.spring : 0;
}

template <int D>
void BodiesSystem<D>::open(Mode& mode, std::size_t place, std::vector<double>& x,
                           std::vector<Change>& changes) const {
  const auto one = mode.closed[place];
  const auto at = layout(x);
  const double rate = approach(one.contact, x).gap_rate;
  if (const auto* law = contact::branched(setting_.contact[one.contact].law)) {
    mode.memory[one.contact] = one.past;
    contact::end(mode.memory[one.contact], *law);
  }
  auto& totals = mode.totals[one.contact];
  totals.normal += x[at.normal(one.slot)];
  for (Index k = 0; k < at.tangents; ++k) totals.tangential[k] += x[at.tangential(one.slot) + k];
  const double* loss = &x[at.losses(one.slot)];
  totals.friction += loss[0] + held_by_spring(one, x);
  totals.rescale += loss[1] + held_at_the_end(mode, place, x);
  totals.damper += loss[2];
  std::fill_n(x.begin() + at.spring(one.slot), at.slot_size, 0.0);
  mode.idle.push_back(one.slot);
  mode.closed.erase(mode.closed.begin() + static_cast<Index>(place));
  changes.push_back({one.contact, BodyEvent::open, -rate});
}

template <int D>
void BodiesSystem<D>::turn(ClosedContact& one, std::vector<double>& x, std::vector<Change>& changes) const {
  const auto& friction = setting_.contact[one.contact].tangential;
  one.unloading = !one.unloading;
  if (const auto* law = contact::branched(setting_.contact[one.contact].law))
    contact::turn(one.past, *law, -approach(one.contact, x).gap);
  changes.push_back({one.contact, one.unloading ? BodyEvent::unload : BodyEvent::load});
  if (friction.law != TangentialLaw::mindlin || one.friction != Friction::stick || one.slack) return;
  const double spring = friction.stiffness * std::sqrt(motion(one.contact, x).indentation);
  const double factor = one.unloading ? 1 / spring : spring;  // T to ξ, or back
  for (Index k = 0; k < BodiesLayout<D>::tangents; ++k) x[layout(x).spring(one.slot) + k] *= factor;
}

/// Contacts that part beyond their end where another guard fires, or within rounding of it where their phase
/// could not go on.
template <int D>
void BodiesSystem<D>::open_parted(Mode& mode, std::vector<double>& x, std::vector<Change>& changes) const {
  for (std::size_t i = mode.closed.size(); i-- > 0;)
    if (has_parted(setting_, layout(x), mode.closed[i], x)) open(mode, i, x, changes);
}

/// Contacts whose load has vanished where another guard fires, or within rounding of that: their own would
/// fire no more. Of one whose own has just fired the load is rounding, of either sign.
template <int D>
void BodiesSystem<D>::slacken(Mode& mode, ConstState x, std::vector<Change>& changes) const {
  const auto may_let_go = [&](const ClosedContact& one) {
    const auto& law = setting_.contact[one.contact].law;
    const Index own = phase_.slot_guard(one.slot, SlotGuard::load);
    return !one.slack && (contact::pulls(law) || contact::goes_slack(law)) &&
           !std::binary_search(fired_.begin(), fired_.end(), own);
  };
  if (std::none_of(mode.closed.begin(), mode.closed.end(), may_let_go)) return;
  field(mode, x);
  for (std::size_t i = 0; i < mode.closed.size(); ++i) {
    auto& one = mode.closed[i];
    const auto& now = field_.contact(i);
    const auto& contact = setting_.contact[one.contact];
    const double noise = load_noise<double>(contact.law, setting_.rest_speed());
    if (!may_let_go(one) || !(now.motion.gap_rate > 0) || !(load_of(contact, now) < -noise)) continue;
    one.slack = true;
    changes.push_back({one.contact, BodyEvent::slack});
  }
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
      return turn(one, x, changes);
    case SlotGuard::load:
      x[layout(x).losses(one.slot)] += held_at_the_cap(mode, place, x);
      one.slack = !one.slack;
      changes.push_back({one.contact, one.slack ? BodyEvent::slack : BodyEvent::grip});
      if (!one.slack) begin_friction(mode, place, Start::grip, x, changes);
      return;
    case SlotGuard::yield:
      contact::yield(one.past);
      changes.push_back({one.contact, BodyEvent::yield});
  }
}

/// What one guard that has fired changes; `touching` is as it was before any did.
template <int D>
void BodiesSystem<D>::pass_guard(Index guard, const std::vector<Index>& touching, Mode& mode,
                                 std::vector<double>& x, std::vector<Change>& changes) const {
  const Index gaps = phase_.gap_guard(0), partings = phase_.parting_guard(0), strays = phase_.stray_guard(0);
  if (guard >= phase_.escape_guard(0)) return;  // whether all is over is asked next
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
    if (one == mode.closed.end()) return;
    pass_slot(static_cast<SlotGuard>(guard % guards_per_slot), mode, one - mode.closed.begin(), x, changes);
  }
}

template <int D>
void BodiesSystem<D>::transition(Mode& mode, const std::vector<Index>& fired, std::vector<double>& x,
                                 std::vector<Change>& changes) const {
  yielded_.clear();
  for (const auto& one : mode.closed)
    if (is_yielding(one)) yielded_.push_back(one.slot);
  touching_ = mode.touching;
  fired_ = fired;
  std::sort(fired_.begin(), fired_.end());
  for (const Index guard : fired_) pass_guard(guard, touching_, mode, x, changes);
  open_parted(mode, x, changes);
  slacken(mode, x, changes);
  stop_yielding(yielded_, mode, x, changes);
  leave_rest(mode, x);
  if (fired.empty()) stay_at_rest(mode, x, changes);
  hold_or_release(mode, x, changes);
  refresh_near(setting_, layout(x), x, mode);
}

template <int D>
bool BodiesSystem<D>::is_over(const Mode& mode, ConstState x, bool) const {
  if (over_ == Over::at_time_limit) return false;
  if (!mode.closed.empty()) {
    if (!is_held(setting_, layout(x), mode, x, field_)) return false;
    phase_.bind(mode);
    return !phase_.comes_together(x);
  }
  phase_.bind(mode);
  return phase_.is_ballistic() ? !phase_.comes_together(x) : phase_.flies_apart(x);
}

template class BodiesSystem<2>;
template class BodiesSystem<3>;

}  // namespace mariotte::model
