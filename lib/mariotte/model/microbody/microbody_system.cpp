#include "mariotte/model/microbody/microbody_system.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/microbody/microbody_field.hpp"

namespace mariotte::model {

using flow::TipPhase;

namespace {

Vector3 unit(const Vector3& v) {
  const double size = norm(v);
  return size > 0 ? (1 / size) * v : Vector3{};
}

bool has_fired(TipGuard guard, Index i, const std::vector<Index>& fired) {
  return std::find(fired.begin(), fired.end(), guard_index(i, guard)) != fired.end();
}

std::array<bool, 2> closed_since(const MicrobodyMode& before, const MicrobodyMode& now) {
  std::array<bool, 2> closed = {};
  for (std::size_t i = 0; i < closed.size(); ++i)
    closed[i] = before.tip[i].contact == TipContact::clear && now.tip[i].contact != TipContact::clear;
  return closed;
}

}  // namespace

MicrobodySystem::MicrobodySystem(const Microbody& body, double accuracy, bool balance, WatchedSigns watched)
    : body_(dimensionless(body)),
      layout_(microbody_layout(body_.tips(), balance)),
      accuracy_(reachable_accuracy(body_, accuracy)),
      phase_(body_, layout_, accuracy_, watched) {}

Vector3 MicrobodySystem::needed_friction(Mode mode, Index i, ConstState x) const {
  mode.tip[i].contact = TipContact::sticking;
  return mechanics().forces(x, mode).friction[i];
}

/// The last slip has ended a little behind zero, within the noise. What comes next is measured from there:
/// its end is seen wherever it began.
void MicrobodySystem::start_from_rest(TipMode& tip, Index i, const Vector3& direction, ConstState x) const {
  tip.direction = direction;
  tip.rest = dot(mechanics().tip(x, i).slip, direction);
}

/// A tip at rest on the plane either holds or starts to slip along the acceleration that it is free to take.
void MicrobodySystem::choose_friction(Mode& mode, Index i, ConstState x, double noise,
                                      std::vector<Change>& changes) const {
  auto& tip = mode.tip[i];
  const double normal = mechanics().normal_force(mechanics().tip(x, i), i);
  const Vector3 needed = needed_friction(mode, i, x);
  tip.start = SlipStart::moving;
  tip.at_touch = false;
  if (norm(needed) <= contact::limit(body_.friction, normal) + noise) {
    tip.contact = TipContact::sticking;
    changes.push_back({i, TipEvent::stick});
    return;
  }
  tip.contact = TipContact::sliding;
  tip.start = SlipStart::turning;
  start_from_rest(
      tip, i,
      body_.motion == TipPhase::Motion::spatial ? mechanics().slip_from_rest(x, mode, i) : unit(-1 * needed),
      x);
  changes.push_back({i, TipEvent::slip});
}

void MicrobodySystem::close(Mode& mode, Index i, ConstState x, std::vector<Change>& changes) const {
  auto& tip = mode.tip[i];
  const auto& law = body_.law[static_cast<std::size_t>(i)];
  const double velocity = mechanics().tip(x, i).velocity;
  tip = {.contact = TipContact::sliding};
  tip.force_sign = law.adhesion > 0 && 1 + law.damping_adhesion * velocity > 0 ? -1 : 1;
  changes.push_back({i, TipEvent::close, std::abs(velocity)});
}

bool MicrobodySystem::slides(Index i, ConstState x) const {
  const auto here = mechanics().tip(x, i);
  const Vector3 v = vector_at(x, layout_.place.velocity);
  const double rounding = 16 * epsilon * (norm(v) + norm(mechanics().spin(x)) * norm(here.lever));
  const bool spatial = body_.motion == TipPhase::Motion::spatial;
  return norm(here.slip) > (spatial ? std::max(rounding, mechanics().slip_noise) : rounding);
}

/// Tips that have closed at this instant slide on, or hold if they can, all at once. All forces are zero yet,
/// but not their ratio: it is asked of the state as it will be, barely indented.
void MicrobodySystem::grip(Mode& mode, const std::array<bool, 2>& closed, ConstState x,
                           std::vector<Change>& changes) const {
  if (!closed[0] && !closed[1]) return;
  std::vector<double> soon(x.begin(), x.end());
  std::array<bool, 2> rests = {};
  for (Index i = 0; i < layout_.tips; ++i) {
    if (!closed[i]) continue;
    auto& tip = mode.tip[i];
    rests[i] = !slides(i, x);
    soon[layout_.place.gap[i]] = -epsilon * epsilon;
    if (rests[i])
      tip.contact = TipContact::sticking;
    else
      tip.direction = unit(mechanics().tip(x, i).slip);
  }
  for (Index i = 0; i < layout_.tips; ++i) {
    if (!rests[i]) continue;
    choose_friction(mode, i, soon, 0, changes);
    mode.tip[i].at_touch = mode.tip[i].contact == TipContact::sliding;
  }
  if (rests[0] && rests[1]) hold_or_release(mode, soon, changes);
}

bool MicrobodySystem::force_has_turned(const TipMode& tip, Index i, ConstState x) const {
  const auto here = mechanics().tip(x, i);
  return tip.force_sign *
             contact::pressure(body_.law[static_cast<std::size_t>(i)], here.indentation, here.velocity) <
         0;
}

void MicrobodySystem::flip_force(Mode& mode, Index i, std::vector<Change>& changes) const {
  auto& tip = mode.tip[i];
  tip.force_sign = -tip.force_sign;
  changes.push_back({i, tip.force_sign > 0 ? TipEvent::force_positive : TipEvent::force_negative});
}

/// At the edge of the cone friction goes on as it was, and the slip against it.
void MicrobodySystem::release(Mode& mode, Index i, ConstState x, std::vector<Change>& changes) const {
  auto& tip = mode.tip[i];
  start_from_rest(tip, i, unit(-1 * needed_friction(mode, i, x)), x);
  tip.contact = TipContact::sliding;
  tip.start = SlipStart::breaking;
  tip.at_touch = false;
  changes.push_back({i, TipEvent::slip});
}

/// A slip that an event of another kind has interrupted goes on, or starts over if it has hardly begun.
void MicrobodySystem::go_on(TipMode& tip, Index i, ConstState x) const {
  const Vector3 slip = mechanics().tip(x, i).slip;
  if (body_.motion == TipPhase::Motion::spatial && norm(slip) > mechanics().slip_noise)
    tip.direction = unit(slip);
  const double least = body_.motion == TipPhase::Motion::spatial ? mechanics().slip_noise : 0;
  tip.at_touch = false;
  const bool moves = dot(slip, tip.direction) > least;
  tip.start = moves ? SlipStart::moving : SlipStart::turning;
  if (moves) tip.rest = 0;
}

/// Friction that changes at one tip is passed on to the other: what stuck may not hold any more.
void MicrobodySystem::hold_or_release(Mode& mode, ConstState x, std::vector<Change>& changes) const {
  for (Index i = 0; i < layout_.tips && layout_.tips > 1; ++i) {
    if (mode.tip[i].contact != TipContact::sticking) continue;
    const double normal = mechanics().normal_force(mechanics().tip(x, i), i);
    if (norm(needed_friction(mode, i, x)) > mechanics().holding(normal)) release(mode, i, x, changes);
  }
}

void MicrobodySystem::mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const {
  mode = {};
  for (Index i = 0; i < layout_.tips; ++i)
    if (x[layout_.place.gap[i]] <= 0 && mechanics().tip(x, i).velocity < 0) close(mode, i, x, changes);
  if (body_.friction.coefficient > 0) grip(mode, closed_since({}, mode), x, changes);
}

/// The cone closes so near to F_n = 0 that a flow may find both at once and name one.
void MicrobodySystem::flip_unnamed_forces(Mode& mode, const std::vector<Index>& fired, ConstState x,
                                          std::vector<Change>& changes) const {
  for (Index i = 0; i < layout_.tips; ++i)
    if (mode.tip[i].contact != TipContact::clear && force_has_turned(mode.tip[i], i, x) &&
        !has_fired(TipGuard::force, i, fired))
      flip_force(mode, i, changes);
}

/// In space a slip that is quick to turn may have passed a right angle within one step. What is below a third
/// of the accuracy counts as rest.
bool MicrobodySystem::slips_on(Index i, ConstState x) const {
  return body_.motion == TipPhase::Motion::spatial &&
         norm(mechanics().tip(x, i).slip) > 30 * mechanics().slip_noise;
}

void MicrobodySystem::touch_or_open(Mode& mode, Index i, ConstState x, std::vector<Change>& changes) const {
  if (mode.tip[i].contact == TipContact::clear) return close(mode, i, x, changes);
  mode.tip[i] = {};
  ++mode.impacts;
  changes.push_back({i, TipEvent::open, std::abs(mechanics().tip(x, i).velocity)});
}

/// Tips that part where another guard has fired within rounding of their end: no time is left until then, and
/// forces as small as that have no sign.
void MicrobodySystem::open_parted(Mode& mode, const std::vector<Index>& fired, ConstState x,
                                  std::vector<Change>& changes) const {
  const double rounding = 4096 * epsilon * body_.time;
  for (Index i = 0; i < layout_.tips; ++i) {
    if (mode.tip[i].contact == TipContact::clear || has_fired(TipGuard::gap, i, fired)) continue;
    const double rise = mechanics().tip(x, i).velocity;
    if (rise > 0 && x[layout_.place.gap[i]] + rounding * rise >= 0) touch_or_open(mode, i, x, changes);
  }
}

/// Of a tip that has opened at this instant, what else has fired says nothing any more.
void MicrobodySystem::pass(TipGuard guard, Mode& mode, Index i, ConstState x,
                           std::vector<Change>& changes) const {
  if (guard != TipGuard::gap && mode.tip[i].contact == TipContact::clear) return;
  switch (guard) {
    case TipGuard::gap:
      return touch_or_open(mode, i, x, changes);
    case TipGuard::force:
      return flip_force(mode, i, changes);
    case TipGuard::slip:
      if (!slips_on(i, x)) choose_friction(mode, i, x, mechanics().force_noise, changes);
      return;
    case TipGuard::cone:
      return release(mode, i, x, changes);
    case TipGuard::turn_back:
      mode.captured = true;
      changes.push_back({i, TipEvent::capture});
  }
}

/// The last tip has opened with the mass centre at the reach of the tips, or higher, so that the guard which
/// waits for that would wait for ever.
bool MicrobodySystem::has_escaped(const Mode& mode, ConstState x) const {
  const auto is_clear = [](const TipMode& tip) { return tip.contact == TipContact::clear; };
  if (body_.symmetric || body_.gravity > 0 || !std::all_of(mode.tip.begin(), mode.tip.end(), is_clear))
    return false;
  const double rounding = 64 * epsilon * reach(body_.body);
  return x[layout_.place.velocity] > 0 && clearance(mechanics(), x) >= -rounding;
}

void MicrobodySystem::transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                                 std::vector<Change>& changes) const {
  const bool rough = body_.friction.coefficient > 0;
  const Mode before = mode;
  open_parted(mode, fired, x, changes);
  for (Index i = 0; rough && i < layout_.tips; ++i)
    if (mode.tip[i].contact == TipContact::sliding) go_on(mode.tip[i], i, x);
  flip_unnamed_forces(mode, fired, x, changes);
  for (const Index guard : fired) {
    if (guard == escape_guard(layout_.tips)) mode.escaped = true;
    if (guard == rest_guard(layout_.tips)) finish(mode, changes);
    const Index i = guard / guards_per_tip;
    if (i < layout_.tips) pass(static_cast<TipGuard>(guard % guards_per_tip), mode, i, x, changes);
  }
  mode.escaped |= has_escaped(mode, x);
  if (!rough) return;
  grip(mode, closed_since(before, mode), x, changes);
  hold_or_release(mode, x, changes);
}

bool MicrobodySystem::is_over(const Mode& mode, ConstState x, bool) const {
  if (mode.escaped) return true;
  for (Index i = 0; i < layout_.tips; ++i)
    if (mode.tip[i].contact != TipContact::clear)
      return body_.after_capture == AfterCapture::stop && (mode.captured || phase_.unrest(x) <= 0);
  return mode.impacts >= body_.impacts;
}

/// A body that is over while a tip touches is captured, though it may never have turned back.
void MicrobodySystem::finish(Mode& mode, std::vector<Change>& changes) const {
  for (Index i = 0; i < layout_.tips && !mode.captured; ++i) {
    if (mode.tip[i].contact == TipContact::clear) continue;
    mode.captured = true;
    changes.push_back({i, TipEvent::capture});
  }
}

hybrid::Ending MicrobodySystem::ending(const Mode& mode) const {
  const bool stays = mode.captured && body_.after_capture == AfterCapture::stop;
  return stays ? hybrid::Ending::captured : hybrid::Ending::separated;
}

MicrobodyPhase& MicrobodySystem::problem(const Mode& mode) {
  phase_.bind(mode);
  return phase_;
}

}  // namespace mariotte::model
