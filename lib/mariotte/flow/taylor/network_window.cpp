// Contacts linked in any way in the window: those that carry force, and those that these move.
#include <algorithm>
#include <cmath>

#include "mariotte/flow/taylor/window_parts.hpp"

namespace mariotte::flow::taylor {
namespace {

/// Networks with fewer contacts are expanded as a whole.
constexpr Index least = 12;

/// Rates are sums of products: what touches at rest has the rounding of zero.
double settled_rate(const LinkedPhase& phase, ConstState x, Index j) {
  const double rate = -gap_rate(phase.direction[j], x);
  const bool rests = phase.contact[j].role == Role::touching && std::abs(rate) <= 8 * epsilon * phase.speed;
  return rests ? 0 : rate;
}

/// What stays outside flies freely and is watched only where it is open.
bool is_active(const LinkedPhase& phase, ConstState x, Index j) {
  const auto& c = phase.contact[j];
  if (c.role != Role::touching) return c.role != Role::open;
  return -x[c.gap] > wake_depth(c, phase.speed) || settled_rate(phase, x, j) > 0;
}

/// The contacts whose indentations the force of one accelerates.
std::span<const int> moved_by(const LinkedPhase& phase, Index j) {
  const auto& of = phase.coupling;
  return std::span(of.near).subspan(of.first[j], of.first[j + 1] - of.first[j]);
}

void add(Window& w, Index j) {
  if (w.lane_of[j] >= 0) return;
  w.lane_of[j] = 0;
  w.found.push_back(static_cast<int>(j));
}

/// All that is moved by what has been found since `from`.
void add_moved(Window& w, std::size_t from, bool touching_alone) {
  for (const std::size_t end = w.found.size(); from < end; ++from) {
    const int j = w.found[from];
    if (touching_alone && w.network->contact[j].role != Role::touching) continue;
    for (const int i : moved_by(*w.network, j)) add(w, i);
  }
}

/// What pushes, what that moves, and beyond what touches, which wakes next, what that will move.
void find_inside(Window& w) {
  const auto& phase = *w.network;
  const Index count = std::ssize(phase.contact);
  const bool all = w.drives || count < least;
  w.found.clear();
  w.lane_of.assign(count, -1);
  for (Index j = 0; j < count; ++j)
    if (all || is_active(phase, w.x, j)) add(w, j);
  if (all) return;
  if (w.found.empty()) add(w, 0);
  const auto active = w.found.size();
  add_moved(w, 0, false);
  add_moved(w, active, true);
}

/// One lane for each, those that push first: where none of some does, series have little to do. The others
/// fly on.
void take_lanes(Window& w) {
  const auto& phase = *w.network;
  w.contacts.clear();
  for (const bool pushes : {true, false})
    for (const int j : w.found) {
      if (phase.contact[j].pushes() != pushes) continue;
      w.lane_of[j] = static_cast<int>(w.contacts.size());
      w.contacts.push_back(&phase.contact[j]);
    }
  begin(w);
  for (Index j = 0; j < std::ssize(phase.contact); ++j)
    if (w.lane_of[j] < 0) add_loose(w, phase.contact[j], settled_rate(phase, w.x, j), 0);
}

/// The part of the coupling that is inside.
void couple_network(Window& w) {
  const auto& of = w.network->coupling;
  const auto outside = [&](int i) { return w.lane_of[i] < 0; };
  w.coupling.clear();
  for (int lane = 0; lane < w.lanes.count; ++lane) {
    const Index j = w.number(lane);
    const auto moved = moved_by(*w.network, j);
    for (int i = of.first[j]; i < of.first[j + 1]; ++i)
      if (!outside(of.near[i])) w.coupling.add(w.lane_of[of.near[i]], of.weight[i]);
    w.coupling.end_row();
    w.at_edge.push_back(w.contact(lane).pushes() && std::any_of(moved.begin(), moved.end(), outside));
  }
  link(w, w.coupling);
}

}  // namespace

void place(Window& w, const LinkedPhase& phase, State x, double time) {
  w.row = nullptr;
  w.network = &phase;
  w.speed = phase.speed;
  w.fade_speed = phase.fade_speed;
  w.x = x;
  w.since = w.time = time;
  w.falls_outside = false;
  find_inside(w);
  take_lanes(w);
  auto& l = w.lanes;
  for (int lane = 0; lane < l.count; ++lane) {
    const Index j = w.number(lane);
    l.left[lane] = -phase.coupling.weight[phase.coupling.first[j]];  // of the contact itself
    l.right[lane] = l.drive[lane] = 0;
    fill(w, lane, settled_rate(phase, x, j));
  }
  w.velocity.assign(x.begin(), x.begin() + phase.dofs);
  couple_network(w);
  settle(w);
}

bool has_outgrown_network(const Window& w) {
  for (int lane = 0; lane < w.lanes.count; ++lane)
    if (w.at_edge[lane] && w.lanes.indentation[lane] > w.lanes.acts_above[lane]) return true;
  return false;
}

}  // namespace mariotte::flow::taylor
