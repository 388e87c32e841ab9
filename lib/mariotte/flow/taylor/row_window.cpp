// Rows in the window.
#include <algorithm>
#include <cmath>

#include "mariotte/flow/taylor/window_parts.hpp"

namespace mariotte::flow::taylor {
namespace {

double rate(const SerialPhase& phase, ConstState x, Index j) {
  return x[phase.body[j].velocity] - x[phase.body[j + 1].velocity];
}
double drive(const SerialPhase& phase, Index j) {
  return phase.body[j].acceleration - phase.body[j + 1].acceleration;
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
  for (Index j = 0; j < static_cast<Index>(w.row->contact.size()); ++j) {
    if (j >= w.first && j < w.first + w.lanes.count) continue;
    if (w.row->contact[j].role != Role::open) continue;
    const double time = w.since + closing_time(*w.row, w.x, j);
    if (time >= w.outside_time) continue;
    w.outside_time = time;
    w.outside = j;
  }
}

void fill(Window& w, int lane) {
  const auto& phase = *w.row;
  const Index j = w.first + lane;
  auto& l = w.lanes;
  l.left[lane] = phase.body[j].inverse_mass;
  l.right[lane] = phase.body[j + 1].inverse_mass;
  l.drive[lane] = drive(phase, j);
  fill(w, lane, rate(phase, w.x, j));
}

/// Rows with more contacts than a row of lanes holds, or with branches that are no powers, are expanded as
/// contacts linked in any way.
void couple(Window& w) {
  auto& l = w.lanes;
  l.linked = false;
  w.coupling.clear();
  for (int j = 0; j < l.count; ++j) {
    for_each_felt(l, j, [&](int other, double weight) { w.coupling.add(other, weight); });
    w.coupling.end_row();
  }
  for (int j = 0; j < l.count; ++j) {
    l.left[j] += l.right[j];
    l.right[j] = 0;
  }
  link(w, w.coupling);
}

bool is_touching(const SerialPhase& phase, Index j) {
  return phase.contact[j].role == Role::touching;
}

}  // namespace

void place(Window& w, const SerialPhase& phase, State x, double time) {
  const Index count = static_cast<Index>(phase.contact.size());
  Index from = 0, to = count - 1;
  while (from < count && !is_active(phase, x, from)) ++from;
  while (to >= from && !is_active(phase, x, to)) --to;
  // One contact more on each side, and another where that one is about to be pressed.
  if (from > 0 && is_touching(phase, --from) && from > 0) --from;
  if (to + 1 < count && is_touching(phase, ++to) && to + 1 < count) ++to;
  w.row = &phase;
  w.network = nullptr;
  w.speed = phase.speed;
  w.fade_speed = phase.fade_speed;
  w.x = x;
  w.since = w.time = time;
  w.first = from;
  begin(w, std::span(phase.contact).subspan(from, to - from + 1));
  for (int lane = 0; lane < w.lanes.count; ++lane) fill(w, lane);
  w.velocity.resize(w.lanes.count + 1);
  for (int body = 0; body <= w.lanes.count; ++body) w.velocity[body] = x[phase.body[from + body].velocity];
  find_outside(w);
  w.lanes.linked = false;
  if (w.lanes.count > row_limit || w.lanes.widened) couple(w);
  settle(w);
}

bool has_outgrown(const Window& w) {
  if (!w.row) return false;
  const int last = w.lanes.count - 1;
  const auto awake = [&](int j) { return w.lanes.indentation[j] > w.acts_above[j]; };
  const bool at_left_end = w.first == 0,
             at_right_end = w.first + last + 1 == static_cast<Index>(w.row->contact.size());
  return (!at_left_end && awake(0)) || (!at_right_end && awake(last));
}

void write_outside(const Window& w, double elapsed, State x) {
  if (!w.row) return;
  const auto& phase = *w.row;
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

}  // namespace mariotte::flow::taylor
