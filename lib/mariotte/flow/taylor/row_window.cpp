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
  return rate(phase, x, j) > 0 || drive(phase, j) != 0 || -x[c.gap] > wake_depth(c, phase.speed);
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

/// What of contacts from … to − 1 moves, and which gap closes first.
void find_loose(Window& w, Index from, Index to) {
  const auto& phase = *w.row;
  for (Index j = from; j < to; ++j) {
    if (rate(phase, w.x, j) == 0 && drive(phase, j) == 0) continue;
    w.loose.push_back(j);
    if (phase.contact[j].role != Role::open) continue;
    const double time = w.since + closing_time(phase, w.x, j);
    if (time >= w.outside_time) continue;
    w.outside_time = time;
    w.outside = j;
    w.outside_guard = phase.contact[j].guard;
  }
}

void find_outside(Window& w) {
  w.outside_time = infinity;
  w.loose.clear();
  w.falls_outside = has_acceleration(*w.row);
  find_loose(w, 0, w.first);
  find_loose(w, w.first + w.lanes.count, std::ssize(w.row->contact));
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

/// A contact that touches and is not deep enough to push its neighbours.
bool dozes(const SerialPhase& phase, ConstState x, Index j) {
  const auto& c = phase.contact[j];
  return c.role == Role::touching && -x[c.gap] <= wake_depth(c, phase.speed) && drive(phase, j) == 0;
}

struct Range {
  Index from, to;
};

/// A contact that begins: its neighbours, if they touch, get forces of their own at once.
bool begins(const SerialPhase& phase, ConstState x, Index j) {
  return is_onset(phase.contact[j], -x[phase.contact[j].gap]);
}

/// Contacts beyond one at the edge that the window must hold: the next, which it moves, unless it has no
/// force itself; and, where the next one gets force at once, the one after that.
Index needed_beyond(const SerialPhase& phase, ConstState x, Index edge) {
  if (begins(phase, x, edge)) return 2;
  return dozes(phase, x, edge) ? 0 : 1;
}

/// Contacts that the window must hold, and as many that touch, and so wake next, as fill its registers.
Range range_of(const SerialPhase& phase, ConstState x) {
  const Index count = static_cast<Index>(phase.contact.size());
  Index from = 0, to = count - 1;
  while (from < count && !is_active(phase, x, from)) ++from;
  while (to >= from && !is_active(phase, x, to)) --to;
  if (from == count) return {std::max<Index>(0, from - 1), to};
  const auto touches = [&](Index j) { return phase.contact[j].role == Role::touching; };
  const Index before = needed_beyond(phase, x, from), after = needed_beyond(phase, x, to);
  for (Index k = 0; k < before && from > 0 && (k == 0 || touches(from)); ++k) --from;
  for (Index k = 0; k < after && to + 1 < count && (k == 0 || touches(to)); ++k) ++to;
  const auto has_room = [&] { return (to - from + 1) % lane_sizes.front() != 0; };
  while (has_room() && to + 1 < count && touches(to)) ++to;
  while (has_room() && from > 0 && touches(from)) --from;
  return {from, to};
}

}  // namespace

void place(Window& w, const SerialPhase& phase, State x, double time) {
  const auto [from, to] = w.drives ? Range{0, std::ssize(phase.contact) - 1} : range_of(phase, x);
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
  if (w.lanes.count > row_limit || w.lanes.widened || w.drives) couple(w);
  settle(w);
}

bool has_outgrown(const Window& w) {
  if (!w.row) return false;
  const int last = w.lanes.count - 1;
  const auto awake = [&](int j) { return w.lanes.indentation[j] > w.lanes.acts_above[j]; };
  const bool at_left_end = w.first == 0,
             at_right_end = w.first + last + 1 == static_cast<Index>(w.row->contact.size());
  return (!at_left_end && awake(0)) || (!at_right_end && awake(last));
}

void write_outside(const Window& w, double elapsed, State x) {
  if (!w.row) return;
  const auto& phase = *w.row;
  if (x.data() != w.x.data()) std::copy(w.x.begin(), w.x.end(), x.begin());
  for (const Index j : w.loose)
    x[phase.contact[j].gap] =
        w.x[phase.contact[j].gap] - elapsed * (rate(phase, w.x, j) + 0.5 * elapsed * drive(phase, j));
  if (!w.falls_outside) return;
  const auto is_inside = [&](Index i) { return i >= w.first && i <= w.first + w.lanes.count; };
  for (Index i = 0; i < static_cast<Index>(phase.body.size()); ++i)
    if (!is_inside(i))
      x[phase.body[i].velocity] = w.x[phase.body[i].velocity] + elapsed * phase.body[i].acceleration;
}

}  // namespace mariotte::flow::taylor
