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

void find_outside(Window& w) {
  const auto& phase = *w.row;
  w.falls_outside = has_acceleration(phase);
  const auto add = [&](Index from, Index to) {
    for (Index j = from; j < to; ++j) add_loose(w, phase.contact[j], rate(phase, w.x, j), drive(phase, j));
  };
  add(0, w.first);
  add(w.first + w.lanes.count, std::ssize(phase.contact));
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
  w.contacts.clear();
  for (Index j = from; j <= to; ++j) w.contacts.push_back(&phase.contact[j]);
  begin(w);
  for (int lane = 0; lane < w.lanes.count; ++lane) fill(w, lane);
  w.velocity.resize(w.lanes.count + 1);
  for (int body = 0; body <= w.lanes.count; ++body) w.velocity[body] = x[phase.body[from + body].velocity];
  find_outside(w);
  w.lanes.linked = false;
  settle(w);
}

bool has_outgrown_row(const Window& w) {
  const int last = w.lanes.count - 1;
  const auto awake = [&](int j) { return w.lanes.indentation[j] > w.lanes.acts_above[j]; };
  const bool at_left_end = w.first == 0,
             at_right_end = w.first + last + 1 == static_cast<Index>(w.row->contact.size());
  return (!at_left_end && awake(0)) || (!at_right_end && awake(last));
}

bool has_shrunk(const Window& w) {
  if (!w.row || w.lanes.count > most_row_limit || is_in_blocks(w.lanes)) return false;
  const auto is_open = [](const PhaseContact* c) { return c->role == Role::open; };
  const auto busy = std::find_if_not(w.contacts.begin(), w.contacts.end(), is_open);
  const auto needed = 1 + static_cast<int>(w.contacts.end() - busy);  // one beside them
  return std::any_of(lane_sizes.begin(), lane_sizes.end(),
                     [&](int size) { return needed <= size && size < w.lanes.count; });
}

void write_falls(const Window& w, double elapsed, State x) {
  const auto& body = w.row->body;
  const auto is_inside = [&](Index i) { return i >= w.first && i <= w.first + w.lanes.count; };
  for (Index i = 0; i < std::ssize(body); ++i)
    if (!is_inside(i)) x[body[i].velocity] = w.x[body[i].velocity] + elapsed * body[i].acceleration;
}

}  // namespace mariotte::flow::taylor
