// What lanes know of their contacts.
#include <algorithm>
#include <cmath>

#include "mariotte/flow/taylor/window_parts.hpp"

namespace mariotte::flow::taylor {

double stored_energy(const Window& w, int lane, double indentation) {
  const auto& c = w.contact(lane);
  if (c.work < 0 || !c.pushes()) return 0;
  const double pulled = c.pull * indentation;
  if (w.lanes.damped || !(indentation > 0)) return -pulled;
  const double n = c.exponent;
  const double width = n == 1 ? 1 : n == 1.5 ? std::sqrt(indentation) : std::pow(indentation, n - 1);
  return c.stiffness * width * indentation * indentation / (n + 1) - pulled;
}

void begin(Window& w) {
  const auto count = w.contacts.size();
  auto& l = w.lanes;
  for (double* row : {l.yield_side, l.turn_side})
    if (l.branched) std::fill_n(row, l.count, 0.0);
  l.resize(static_cast<int>(count));
  l.damped = l.mixed = l.general = l.branched = l.widened = l.segmented = false;
  w.branch.resize(count);
  w.segment.resize(count);
  l.branch = w.branch.data();
  l.segment = w.segment.data();
  for (auto* row : {&w.impulse, &w.work, &w.stored}) row->assign(count, 0);
  w.outside_time = infinity;
  w.outside = nullptr;
  w.loose.clear();
  w.at_edge.clear();
}

namespace {

/// Indentation at the start: on the side where its role holds it, and exactly zero at an onset.
double settled(const PhaseContact& c, double indentation, double rate) {
  if (c.role == Role::open) return std::min(indentation, c.level);
  if (c.width) return indentation;
  if (c.role == Role::touching && c.exponent != 1) return indentation;  // drawn apart a little, without force
  return rate > 0 && is_onset(c, indentation) ? 0 : std::max(indentation, 0.0);
}

/// A damper as δᵖ has k in the power, too.
void fill_damper(Lanes& l, int lane, const PhaseContact& c) {
  l.damped = true;
  l.mixed |= c.grows != Damping::as_slope;
  if (c.grows == Damping::as_force) l.stiffening[lane] = c.damping;
  if (c.grows != Damping::as_force) l.damping[lane] = c.damping;
  if (c.grows != Damping::as_root) return;
  l.general = true;
  l.stiffness[lane] = 0;
  l.steepening[lane] = c.stiffness;
  l.power[lane] = damping_exponent(c.grows, c.exponent);
}

/// A force that begins as √δ, as that of a damper does.
void fill_ring(Lanes& l, int lane, const PhaseContact& c) {
  l.damped = l.mixed = true;
  l.ring[lane] = c.ring;
  l.damping[lane] = c.ring_damping;
}

void fill_law(Lanes& l, int lane, const PhaseContact& c) {
  l.stiffness[lane] = c.stiffness;
  l.power[lane] = c.exponent - 1;
  l.steepening[lane] = l.damping[lane] = l.stiffening[lane] = l.ring[lane] = 0;
  if (c.damping > 0) fill_damper(l, lane, c);
  if (c.ring > 0) fill_ring(l, lane, c);
  l.general |= c.exponent != 1 && c.exponent != 1.5;
}

}  // namespace

void fill(Window& w, int lane, double rate) {
  const auto& c = w.contact(lane);
  auto& l = w.lanes;
  l.rate[lane] = rate;
  l.indentation[lane] = settled(c, -w.x[c.gap] - c.origin, rate);
  fill_law(l, lane, c);
  l.weight[lane] = 1 / c.length;
  l.damped |= c.width != nullptr;
  l.widened |= c.width != nullptr;
  w.branch[lane] = c.width;
  l.width[lane] = c.width ? c.width->curve.root(l.indentation[lane]) : 1;
  const bool by_segments = c.curve && c.pushes();
  l.segmented |= by_segments;
  w.segment[lane] = by_segments ? &segment_of(c, l.indentation[lane]) : nullptr;
  watch(w, lane);
}

void settle(Window& w) {
  auto& l = w.lanes;
  for (int lane = 0; lane < l.count; ++lane) w.stored[lane] = stored_energy(w, lane, l.indentation[lane]);
  w.is_pulled = std::any_of(w.contacts.begin(), w.contacts.end(), [](const auto* c) { return c->pull != 0; });
  if (!w.is_pulled) return;
  for (int lane = 0; lane < l.count; ++lane) {
    for_each_felt(l, lane, [&](int other, double weight) {
      const auto& c = w.contact(other);
      if (c.pushes()) l.drive[lane] -= weight * c.pull;
    });
  }
}

void link(Window& w, const Coupling& coupling) {
  w.lanes.linked = true;
  w.lanes.links = {coupling.first.data(), coupling.near.data(), coupling.weight.data()};
}

namespace {

void watch_branch(const PhaseContact& c, int lane, Lanes& l) {
  const bool yields = c.yields < infinity;
  l.yield_side[lane] = yields ? 1 : 0;
  l.yield_level[lane] = yields ? c.yields - c.origin : 0;
  l.turn_side[lane] = c.turn_side;
  l.turn_level[lane] = c.turn_speed;
  l.branched = true;
}

void set_limits(Window& w, int lane) {
  const auto& c = w.contact(lane);
  auto& l = w.lanes;
  l.acts_above[lane] = c.pushes() ? wake_depth(c, w.speed) : infinity;
  l.late_above[lane] = lateness(c) * l.acts_above[lane];
  l.rooted[lane] = c.role == Role::closed && w.is_sharp(lane) ? 1 : 0;
  l.leeway[lane] = w.has_root(lane) ? l.acts_above[lane] : 0;
  l.fades_below[lane] = c.role == Role::closed ? c.faded() : -infinity;
  l.leaves_noise[lane] = c.role == Role::touching ? c.loaded() : infinity;
}

}  // namespace

void watch(Window& w, int lane) {
  const auto& c = w.contact(lane);
  auto& l = w.lanes;
  const bool damped = c.load_guard >= 0;
  l.side[lane] = l.load_side[lane] = 0;
  l.level[lane] = c.level;
  set_limits(w, lane);
  if (c.branch_guard >= 0) watch_branch(c, lane, l);
  switch (c.role) {
    case Role::open:
      l.side[lane] = -1;
      break;
    case Role::closed:
      l.load_side[lane] = damped ? 1 : 0;
      l.side[lane] = c.opens_loaded() ? 1 : 0;
      l.level[lane] = end_level(c);
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

double load_noise(const Window& w, int lane, double rate_error) {
  const auto& l = w.lanes;
  double size = 0;
  if (w.row)
    size = std::abs(w.velocity[lane]) + std::abs(w.velocity[lane + 1]);
  else
    for (const auto& [dof, g] : w.network->direction[w.number(lane)]) size += std::abs(g * w.velocity[dof]);
  return (l.damping[lane] + l.stiffening[lane]) * std::max(16 * epsilon * size, rate_error);
}

bool has_faint_load(const Window& w, int lane) {
  const auto& l = w.lanes;
  if (w.contact(lane).load_guard < 0 || !(l.rate[lane] < 0)) return false;
  const double d = l.indentation[lane], noise = load_noise(w, lane, 0);
  if (l.stiffening[lane] > 0) return l.stiffness[lane] + l.stiffening[lane] * l.rate[lane] < noise;
  const double stiffness =
      l.stiffness[lane] + (l.steepening[lane] > 0 ? l.steepening[lane] * std::pow(d, l.power[lane]) : 0);
  return stiffness * d + l.damping[lane] * l.rate[lane] < noise;
}

}  // namespace mariotte::flow::taylor
