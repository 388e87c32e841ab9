#include "mariotte/flow/taylor/taylor_window.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/types.hpp"

namespace mariotte::flow::taylor {
namespace {

double rate(const SerialPhase& phase, ConstState x, Index j) {
  return x[phase.body[j].velocity] - x[phase.body[j + 1].velocity];
}
double drive(const SerialPhase& phase, Index j) {
  return phase.body[j].acceleration - phase.body[j + 1].acceleration;
}

/// Depth below which the force of a contact is left out: within the depth that cannot be told from rounding,
/// less for what damping adds to the force. Laws without a branch point need none.
double wake_depth(const PhaseContact& c, double speed) {
  if (c.exponent == 1) return -infinity;
  const double strain = c.damping * speed / (c.stiffness * c.length);
  return 0.5 * c.noise_depth / (1 + strain);
}

/// A contact that the window must hold: what stays outside flies freely and is watched only where it is open.
bool is_active(const SerialPhase& phase, ConstState x, Index j) {
  const auto& c = phase.contact[j];
  if (c.role != Role::touching) return c.role != Role::open;
  return -x[c.gap] > wake_depth(c, phase.speed) || rate(phase, x, j) > 0 || drive(phase, j) != 0;
}

/// First time after 0 at which an open gap that flies freely falls to −level.
double closing_time(const SerialPhase& phase, ConstState x, Index j) {
  const auto& c = phase.contact[j];
  const double gap = x[c.gap] + c.level, speed = rate(phase, x, j), push = drive(phase, j);
  if (push == 0) return speed > 0 ? std::max(0.0, gap / speed) : infinity;
  const double square = speed * speed + 2 * push * gap;  // gap − speed t − push t²/2 = 0
  if (square < 0) return infinity;
  const double root = std::sqrt(square);
  if (speed > 0) return std::max(0.0, 2 * gap / (speed + root));
  return push > 0 ? (root - speed) / push : infinity;
}

void find_outside(Window& w) {
  w.outside_time = infinity;
  for (Index j = 0; j < static_cast<Index>(w.phase->contact.size()); ++j) {
    if (j >= w.first && j < w.first + w.lanes.count) continue;
    if (w.phase->contact[j].role != Role::open) continue;
    const double time = w.since + closing_time(*w.phase, w.x, j);
    if (time >= w.outside_time) continue;
    w.outside_time = time;
    w.outside = j;
  }
}

/// Indentation at the start: on the side where its role holds it, and exactly zero at an onset, where
/// rounding may have left it beside.
double settled(const PhaseContact& c, double indentation, double rate) {
  if (c.role == Role::open) return std::min(indentation, c.level);
  const bool onset = c.role == Role::closed && rate > 0 && indentation <= 16 * epsilon * c.length;
  return onset ? 0 : std::max(indentation, 0.0);
}

void fill(Window& w, int lane) {
  const auto& phase = *w.phase;
  const Index j = w.first + lane;
  const auto& c = phase.contact[j];
  auto& l = w.lanes;
  l.rate[lane] = rate(phase, w.x, j);
  l.indentation[lane] = settled(c, -w.x[c.gap], l.rate[lane]);
  l.stiffness[lane] = c.stiffness;
  l.damping[lane] = c.damping;
  l.power[lane] = c.exponent - 1;
  l.left[lane] = phase.body[j].inverse_mass;
  l.right[lane] = phase.body[j + 1].inverse_mass;
  l.drive[lane] = drive(phase, j);
  l.weight[lane] = 1 / c.length;
  w.wake[lane] = wake_depth(c, phase.speed);
  w.impulse[lane] = w.work[lane] = 0;
  l.damped |= c.damping > 0;
  l.general |= c.exponent != 1 && c.exponent != 1.5;
  watch(w, lane);
}

/// Velocities of the window's bodies where the series says `values`.
template <class Take>
void for_each_velocity(const Window& w, const Values& values, Take&& take) {
  double push = 0;
  for (int lane = 0; lane <= w.lanes.count; ++lane) {
    const auto& body = w.phase->body[w.first + lane];
    const double force = lane < w.lanes.count ? values.impulse[lane] : 0;
    take(lane, w.velocity[lane] + (body.inverse_mass * (push - force) + body.acceleration * values.time));
    push = force;
  }
}

/// What flies freely, `elapsed` after the window was placed.
void write_outside(const Window& w, double elapsed, State x) {
  const auto& phase = *w.phase;
  const Index count = static_cast<Index>(phase.contact.size()), last = w.first + w.lanes.count;
  for (Index j = 0; j < count; ++j) {
    if (j == w.first) j = last;
    if (j >= count) break;
    const auto& c = phase.contact[j];
    x[c.gap] = w.x[c.gap] - elapsed * (rate(phase, w.x, j) + 0.5 * elapsed * drive(phase, j));
    if (c.impulse >= 0) x[c.impulse] = w.x[c.impulse];
    if (c.work >= 0) x[c.work] = w.x[c.work];
  }
  for (Index i = 0; i <= count; ++i) {
    if (i == w.first) i = last + 1;
    if (i > count) break;
    const auto& body = phase.body[i];
    x[body.velocity] = w.x[body.velocity] + elapsed * body.acceleration;
  }
}

void clear(Lanes& l, int lane) {
  for (auto* row : {l.indentation, l.rate, l.active, l.stiffness, l.damping, l.power, l.left, l.right,
                    l.drive, l.side, l.level, l.load_side, l.weight})
    row[lane] = 0;
}

}  // namespace

void watch(Window& w, int lane) {
  const auto& c = w.contact(lane);
  auto& l = w.lanes;
  const bool damped = c.load_guard >= 0;
  l.side[lane] = l.load_side[lane] = 0;
  l.level[lane] = c.level;
  switch (c.role) {
    case Role::open:
      l.side[lane] = -1;
      break;
    case Role::closed:
      (damped ? l.load_side : l.side)[lane] = 1;
      break;
    case Role::slack:
      l.side[lane] = 1;
      l.load_side[lane] = -1;
      break;
    case Role::touching:  // one without a branch point is never left out, and must not pull
      l.side[lane] = w.is_sharp(lane) ? 0 : 1;
      l.level[lane] = c.loaded();
      break;
  }
}

bool place(Window& w, const SerialPhase& phase, State x, double time) {
  const Index count = static_cast<Index>(phase.contact.size());
  Index from = 0, to = count - 1;
  while (from < count && !is_active(phase, x, from)) ++from;
  while (to >= from && !is_active(phase, x, to)) --to;
  // One contact more on each side, and another where that one is about to be pressed.
  const auto touching = [&](Index j) { return phase.contact[j].role == Role::touching; };
  if (from > 0 && touching(--from) && from > 0) --from;
  if (to + 1 < count && touching(++to) && to + 1 < count) ++to;
  if (to - from + 1 > lane_limit) return false;
  w.phase = &phase;
  w.x = x;
  w.since = w.time = time;
  w.first = from;
  const int idle = w.lanes.count;
  w.lanes.count = static_cast<int>(to - from + 1);
  for (int lane = w.lanes.count; lane < idle; ++lane) clear(w.lanes, lane);
  w.lanes.damped = w.lanes.general = false;
  for (int lane = 0; lane < w.lanes.count; ++lane) fill(w, lane);
  for (int body = 0; body <= w.lanes.count; ++body) w.velocity[body] = x[phase.body[from + body].velocity];
  find_outside(w);
  return true;
}

void advance(Window& w, const Values& values) {
  auto& l = w.lanes;
  w.time += values.time;
  for_each_velocity(w, values, [&](Index body, double velocity) { w.velocity[body] = velocity; });
  for (int lane = 0; lane < l.count; ++lane) {
    l.indentation[lane] = values.indentation[lane];
    l.rate[lane] = w.velocity[lane] - w.velocity[lane + 1];
    w.impulse[lane] += values.impulse[lane];
    if (l.damped) w.work[lane] += values.work[lane];
  }
}

void write(const Window& w, State x) {
  write_outside(w, w.time - w.since, x);
  for (int lane = 0; lane < w.lanes.count; ++lane) {
    const auto& c = w.contact(lane);
    x[c.gap] = 0 - w.lanes.indentation[lane];  // never −0
    if (c.impulse >= 0) x[c.impulse] = w.x[c.impulse] + w.impulse[lane];
    if (c.work >= 0) x[c.work] = w.x[c.work] + w.work[lane];
  }
  for (int body = 0; body <= w.lanes.count; ++body)
    x[w.phase->body[w.first + body].velocity] = w.velocity[body];
}

void write(const Window& w, const Values& values, State x) {
  write_outside(w, w.time + values.time - w.since, x);
  for (int lane = 0; lane < w.lanes.count; ++lane) {
    const auto& c = w.contact(lane);
    x[c.gap] = 0 - values.indentation[lane];
    if (c.impulse >= 0) x[c.impulse] = w.x[c.impulse] + w.impulse[lane] + values.impulse[lane];
    if (c.work >= 0) x[c.work] = w.x[c.work] + w.work[lane] + values.work[lane];
  }
  for_each_velocity(
      w, values, [&](Index body, double velocity) { x[w.phase->body[w.first + body].velocity] = velocity; });
}

}  // namespace mariotte::flow::taylor
