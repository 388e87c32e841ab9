#include "mariotte/model/bodies/bodies_phase.hpp"

#include <algorithm>

#include "mariotte/model/bodies/bodies_parting.hpp"
#include "mariotte/model/bodies/bodies_pattern.hpp"
#include "mariotte/model/bodies/bodies_rest.hpp"
#include "mariotte/model/bodies/near_pairs.hpp"

namespace mariotte::model {

using flow::Crossing;

template <int D>
BodiesPhase<D>::BodiesPhase(const BodiesSetting<D>& setting, Index touching)
    : setting_(setting),
      touching_(touching),
      field_(setting),
      directional_(setting),
      sloped_(setting),
      traced_(setting) {
  layout_.bodies = std::ssize(setting.body);
  if constexpr (D == 2) balls_.emplace(setting), cluster_.emplace(setting);
  if constexpr (D == 3)
    for (const auto& body : setting.body)
      free_flight_ = free_flight_ && (body.is_round || body.inertia[1] == body.inertia[2]);
}

namespace {

template <int D>
double damping_of(const SettingContact<D>& contact) {
  const auto* power = contact::power_law(contact.law);
  return power ? power->damping / (power->stiffness * contact.time) : 0;
}

/// A direction that turns at once is as stiff as strong damping: that of a slip that has just left rest, and
/// in space that of a spring that yields, while its force is small: it turns like the slip over the stretch.
constexpr double stiff_turning = 10;
/// That of Mindlin's spring grows like the indentation, so it mostly turns no faster than the contact goes
/// on. A phase that takes more steps is one in which a fast slip makes it stiff.
constexpr Index steps_to_see_turns = 300;
template <int D>
bool yields_in_space(const ClosedContact& one, const SettingContact<D>& contact, TangentialLaw law) {
  return D == 3 && one.friction == Friction::slip && !one.slack && contact.tangential.law == law;
}
constexpr Index most_steps_at_rest = 2000;
/// Whether all rests is asked at events, and after so many steps without any.
constexpr Index steps_between_looks = 500;

}  // namespace

template <int D>
void BodiesPhase<D>::bind(const BodiesMode& mode) {
  mode_ = &mode;
  entries_.clear();
  layout_.slots = std::ssize(mode.idle) + std::ssize(mode.closed);
  set_magnitudes(setting_, layout_, mode, magnitude_);
  // Without gravity what touches at rest stays so while nothing pushes.
  at_peace_ = mode.touching.empty() || norm(setting_.gravity) == 0;
  ballistic_ = mode.closed.empty() && at_peace_ && free_flight_;
  steps_at_rest_ = 0;
  set_crossings();
  set_stiffness();
  recordable_ = !mode.closed.empty() && std::all_of(mode.closed.begin(), mode.closed.end(),
                                                    [&](const auto& one) { return can_be_recorded(one); });
  find_balls();
}

template <int D>
void BodiesPhase<D>::set_crossings() {
  watches_near_ = watches_near(setting_, *mode_);
  strays_ = watches_near_ ? layout_.bodies : 0;
  escapes_ = mode_->closed.empty() && !free_flight_ ? watched_count() : 0;
  crossing_.assign(guard_count(), Crossing::none);
  std::fill_n(crossing_.begin() + gap_guard(0), watched_count(), Crossing::falling);
  for (Index i = 0; i < strays_; ++i) crossing_[stray_guard(i)] = Crossing::falling;
  for (Index k = 0; k < escapes_; ++k) crossing_[escape_guard(k)] = Crossing::rising;
  for (Index k = 0; k < std::ssize(mode_->touching); ++k) crossing_[parting_guard(k)] = Crossing::rising;
  for (const auto& one : mode_->closed) set_crossings(one);
}

/// Of a closed contact.
template <int D>
void BodiesPhase<D>::set_crossings(const ClosedContact& one) {
  const auto& law = setting_.contact[one.contact].law;
  const auto set = [&](SlotGuard guard, Crossing way) { crossing_[slot_guard(one.slot, guard)] = way; };
  set(SlotGuard::open, Crossing::rising);
  if (const Index k = place_watched(one.contact); k >= 0) crossing_[gap_guard(k)] = Crossing::none;
  if (one.friction != Friction::none && !one.slack && !one.from_rest)
    set(SlotGuard::friction, Crossing::falling);
  set(SlotGuard::turn, one.unloading ? Crossing::rising : Crossing::falling);
  if (contact::goes_slack(law) || contact::pulls(law))
    set(SlotGuard::load, one.slack ? Crossing::rising : Crossing::falling);
  if (one.past.branch != contact::Branch::plastic && !one.unloading && yield_depth(law, one.past) < infinity)
    set(SlotGuard::yield, Crossing::falling);
}

/// Natural time, damping, and how long an explicit flow may try.
template <int D>
void BodiesPhase<D>::set_stiffness() {
  time_ = mode_->closed.empty() ? setting_.time : infinity;
  damping_ = 0;
  trial_steps_ = flow::Problem::trial_steps();
  for (const auto& one : mode_->closed) {
    const auto& contact = setting_.contact[one.contact];
    time_ = std::min(time_, contact.time);
    const bool turns_at_once = one.from_rest || yields_in_space(one, contact, TangentialLaw::spring);
    damping_ = std::max({damping_, damping_of(contact), turns_at_once ? stiff_turning : 0});
    if (yields_in_space(one, contact, TangentialLaw::mindlin)) trial_steps_ = steps_to_see_turns;
  }
}

template <int D>
void BodiesPhase<D>::find_balls() {
  is_balls_ = balls_ && balls_->admits(*mode_);
  is_cluster_ = cluster_ && cluster_->admits(*mode_);
  if constexpr (D == 2) {
    if (is_balls_)
      balls_->bind(*mode_, layout_, magnitude_, slot_guard(mode_->closed.front().slot, SlotGuard::open));
    if (is_cluster_)
      cluster_->bind(*mode_, layout_, magnitude_, {gap_guard(0), parting_guard(0), stray_guard(0)});
  }
}

/// Where a spring fades steps become so short that no body moves in them, and the end is never met; what is
/// left of the contact is rounding then.
template <int D>
bool BodiesPhase<D>::is_stuck_at_the_end(ConstState x) const {
  const auto& closed = mode_->closed;
  return std::any_of(closed.begin(), closed.end(), [&](const ClosedContact& one) {
    return fades(setting_, one) && has_parted(setting_, layout_, one, x);
  });
}

template <int D>
flow::Accepted BodiesPhase<D>::accept(ConstState x) {
  if (is_stuck_at_the_end(x)) return flow::Accepted::ended;
  if (++accepted_ % steps_between_looks == 0 && is_held(setting_, layout_, *mode_, x, field_))
    return flow::Accepted::ended;
  const auto& closed = mode_->closed;
  const auto looks = [](const auto& one) {
    return one.friction == Friction::slip && !one.slack && (D == 3 || one.from_rest);
  };
  if (std::none_of(closed.begin(), closed.end(), looks)) return flow::Accepted::unchanged;
  field_.evaluate(layout_, *mode_, x);
  auto done = flow::Accepted::unchanged;
  for (std::size_t i = 0; i < closed.size() && done != flow::Accepted::ended; ++i) {
    if (!looks(closed[i])) continue;
    if (D == 3) weigh_direction(i);
    if (closed[i].from_rest) done = std::max(done, leave_rest(i));
  }
  return done;
}

/// As the force fades, so does what an error of the direction of its friction does; its rate, the inverse of
/// the force, is known ever worse.
template <int D>
void BodiesPhase<D>::weigh_direction(std::size_t i) {
  const auto& one = mode_->closed[i];
  const double full = setting_.contact[one.contact].fading_force();
  const double faded = 0.1 * full / std::max(field_.contact(i).normal, setting_.faint * full);
  std::fill_n(magnitude_.begin() + layout_.spring(one.slot), layout_.tangents,
              direction_magnitude * std::max(1.0, faded));
}

/// A slip from rest may come to rest again once it has been twice as fast as what counts as rest. One that
/// stays at rest for so many steps is held there by friction: the transition looks at it again.
template <int D>
flow::Accepted BodiesPhase<D>::leave_rest(std::size_t i) {
  auto& watched = crossing_[slot_guard(mode_->closed[i].slot, SlotGuard::friction)];
  if (watched != Crossing::none) return flow::Accepted::unchanged;
  if (norm(field_.contact(i).motion.slip) < 2 * setting_.rest_speed())
    return ++steps_at_rest_ > most_steps_at_rest ? flow::Accepted::ended : flow::Accepted::unchanged;
  watched = Crossing::falling;
  return flow::Accepted::rewatched;
}

template <int D>
void BodiesPhase<D>::derivative(ConstState x, State dx) const {
  field_.evaluate(layout_, *mode_, x);
  field_.rates(*mode_, x, dx);
}

/// By colours, for the Jacobian.
template <int D>
const std::vector<flow::Entry>& BodiesPhase<D>::entries() const {
  if (!entries_.empty()) return entries_;
  entries_ = pattern_of(setting_, layout_, *mode_);
  colours_ = colours_of(entries_, size());
  std::stable_sort(entries_.begin(), entries_.end(),
                   [&](auto a, auto b) { return colours_[a.column] < colours_[b.column]; });
  return entries_;
}

/// As many colours at once as slopes are carried.
template <int D>
void BodiesPhase<D>::jacobian(ConstState x, State values) const {
  const auto& all = entries();
  sloped_dx_.resize(size());
  for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
    sloped_x_.assign(x.begin(), x.end());
    const Index first = colours_[all[from].column];
    for (; to < all.size() && colours_[all[to].column] < first + slope_lanes; ++to) {
      const Index column = all[to].column;
      sloped_x_[column].slope[colours_[column] - first] = 1;
    }
    sloped_.evaluate(layout_, *mode_, std::span<const Sloped>(sloped_x_));
    sloped_.rates(*mode_, std::span<const Sloped>(sloped_x_), std::span<Sloped>(sloped_dx_));
    for (std::size_t e = from; e < to; ++e)
      values[e] = sloped_dx_[all[e].row].slope[colours_[all[e].column] - first];
  }
}

template <int D>
std::string BodiesPhase<D>::component(Index index) const {
  if (index >= layout_.clock()) return "contact";
  const Index place = index % BodiesLayout<D>::body_size;
  const char* kind = place < D                          ? "position"
                     : place < D + layout_.attitude     ? "attitude"
                     : place < 2 * D + layout_.attitude ? "velocity"
                                                        : "spin";
  return kind + std::string(" of body ") + std::to_string(index / BodiesLayout<D>::body_size + 1);
}

template class BodiesPhase<2>;
template class BodiesPhase<3>;

}  // namespace mariotte::model
