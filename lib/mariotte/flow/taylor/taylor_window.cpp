#include "mariotte/flow/taylor/taylor_window.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/taylor/window_parts.hpp"

namespace mariotte::flow::taylor {
namespace {

/// Indentation at the start: on the side where its role holds it, and exactly zero at an onset.
double settled(const PhaseContact& c, double indentation, double rate) {
  if (c.role == Role::open) return std::min(indentation, c.level);
  if (c.width) return indentation;
  if (c.role == Role::touching && c.exponent != 1) return indentation;  // drawn apart a little, without force
  return rate > 0 && is_onset(c, indentation) ? 0 : std::max(indentation, 0.0);
}

/// What a contact that pushes stores, but for what the series count as work: all of it without dampers.
double stored_energy(const Window& w, int lane, double indentation) {
  const auto& c = w.contact(lane);
  if (c.work < 0 || !c.pushes()) return 0;
  const double pulled = c.pull * indentation;
  if (w.lanes.damped || !(indentation > 0)) return -pulled;
  const double n = c.exponent;
  const double width = n == 1 ? 1 : n == 1.5 ? std::sqrt(indentation) : std::pow(indentation, n - 1);
  return c.stiffness * width * indentation * indentation / (n + 1) - pulled;
}
/// Put into a contact since the window was placed, and since its time as `values` say.
double work_of(const Window& w, int lane, double indentation, double more) {
  return (w.lanes.damped ? w.work[lane] + more : 0) + stored_energy(w, lane, indentation) - w.stored[lane];
}
/// Impulse of a contact; the series do not count a constant pull.
double impulse_of(const Window& w, const Values& values, int lane) {
  if (!w.is_pulled) return values.impulse[lane];
  const auto& c = w.contact(lane);
  return values.impulse[lane] - (c.pushes() ? c.pull * values.time : 0);
}

/// Velocities of a row's bodies where the series says `values`: use(place in the window, velocity).
template <class Use>
void velocities_of_row(const Window& w, const Values& values, Use&& use) {
  double push = 0;
  const auto* body = &w.row->body[w.first];
  const double *velocity = w.velocity.data(), time = values.time;
  const int count = w.lanes.count;
  const auto move = [&](int i, double force) {
    use(i, velocity[i] + (body[i].inverse_mass * (push - force) + body[i].acceleration * time));
    push = force;
  };
  for (int lane = 0; lane < count; ++lane) move(lane, impulse_of(w, values, lane));
  move(count, 0);
}

/// use(number of a velocity, by how much drives change it) after a time of the step.
template <class Use>
void for_each_gain(const Window& w, double time, Use&& use) {
  for (const auto& one : w.driven)
    for (const auto& [number, share] : one.on_velocity) use(number, share * horner(one.gain, time));
}

void add_impulses(const Window& w, const Values& values, State velocity) {
  for (int lane = 0; lane < w.lanes.count; ++lane) {
    const double impulse = impulse_of(w, values, lane);
    if (impulse == 0) continue;
    for (const auto& [dof, change] : w.network->response[w.number(lane)]) velocity[dof] += change * impulse;
  }
}

/// In the state.
Index place_of(const Window& w, Index velocity) {
  return w.row ? w.row->body[w.first + velocity].velocity : velocity;
}

void write_velocities(const Window& w, const Values& values, State x) {
  if (w.row) {
    velocities_of_row(w, values, [&](int i, double v) { x[place_of(w, i)] = v; });
  } else {
    std::copy(w.velocity.begin(), w.velocity.end(), x.begin());
    add_impulses(w, values, x);
  }
  for_each_gain(w, values.time, [&](int i, double gain) { x[place_of(w, i)] += gain; });
}

/// The clock, and what drives have done, so long after the start of the step.
void write_drives(const Window& w, double time, State x) {
  if (!w.drives) return;
  x[w.drives->clock] = w.x[w.drives->clock] + (w.time + time - w.since);
  for (std::size_t k = 0; k < w.driven.size(); ++k) {
    const auto& one = w.driven[k];
    const Index work = w.drives->drive[k].work;
    x[work] = w.x[work] + (one.done + (time > 0 ? horner(one.work, time) : 0));
  }
}

void set_rates(Window& w) {
  double* rate = w.lanes.rate;
  if (w.row)
    for (int lane = 0; lane < w.lanes.count; ++lane) rate[lane] = w.velocity[lane] - w.velocity[lane + 1];
  else
    for (int lane = 0; lane < w.lanes.count; ++lane)
      rate[lane] = -gap_rate(w.network->direction[w.number(lane)], w.velocity);
}

}  // namespace

void begin(Window& w) {
  const auto count = w.contacts.size();
  auto& l = w.lanes;
  for (double* row : {l.yield_side, l.turn_side})
    if (l.branched) std::fill_n(row, l.count, 0.0);
  l.resize(static_cast<int>(count));
  l.damped = l.mixed = l.general = l.branched = l.widened = false;
  w.branch.resize(count);
  l.branch = w.branch.data();
  for (auto* row : {&w.impulse, &w.work, &w.stored}) row->assign(count, 0);
  w.outside_time = infinity;
  w.outside = nullptr;
  w.loose.clear();
  w.at_edge.clear();
}

namespace {

/// First time after 0 at which an open gap that flies freely falls to −level.
double closing_time(double gap, double rate, double acceleration) {
  if (acceleration == 0) return rate > 0 ? std::max(0.0, gap / rate) : infinity;
  const double square = rate * rate + 2 * acceleration * gap;  // gap − rate t − acceleration t²/2 = 0
  if (square < 0) return infinity;
  const double root = std::sqrt(square);
  if (rate > 0) return std::max(0.0, 2 * gap / (rate + root));
  return acceleration > 0 ? (root - rate) / acceleration : infinity;
}

}  // namespace

void add_loose(Window& w, const PhaseContact& c, double rate, double acceleration) {
  if (rate == 0 && acceleration == 0) return;
  w.loose.push_back({c.gap, rate, acceleration});
  if (c.role != Role::open) return;
  const double time = w.since + closing_time(w.x[c.gap] + c.level, rate, acceleration);
  if (time >= w.outside_time) return;
  w.outside_time = time;
  w.outside = &c;
  w.outside_guard = c.guard;
}

void write_outside(const Window& w, double elapsed, State x) {
  if (x.data() != w.x.data()) std::copy(w.x.begin(), w.x.end(), x.begin());
  for (const auto& one : w.loose)
    x[one.gap] = w.x[one.gap] - elapsed * (one.rate + 0.5 * elapsed * one.acceleration);
  if (w.falls_outside) write_falls(w, elapsed, x);
}

void place(Window& w, const Problem& problem, State x, double time) {
  w.drives = problem.drives();
  if (const auto* row = problem.serial())
    place(w, *row, x, time);
  else
    place(w, *problem.linked(), x, time);
  begin_drives(w);
}

namespace {

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

void fill_law(Lanes& l, int lane, const PhaseContact& c) {
  l.stiffness[lane] = c.stiffness;
  l.power[lane] = c.exponent - 1;
  l.steepening[lane] = l.damping[lane] = l.stiffening[lane] = 0;
  if (c.damping > 0) fill_damper(l, lane, c);
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

void advance(Window& w, const Values& values) {
  auto& l = w.lanes;
  w.time += values.time;
  if (w.row)
    velocities_of_row(w, values, [&](int i, double v) { w.velocity[i] = v; });
  else
    add_impulses(w, values, w.velocity);
  for_each_gain(w, values.time, [&](int i, double gain) { w.velocity[i] += gain; });
  for (auto& one : w.driven) one.done += horner(one.work, values.time);
  std::copy_n(values.indentation, l.count, l.indentation);
  set_rates(w);
  for (int lane = 0; lane < l.count; ++lane) w.impulse[lane] += impulse_of(w, values, lane);
  for (int lane = 0; l.damped && lane < l.count; ++lane) w.work[lane] += values.work[lane];
  for (int lane = 0; l.widened && lane < l.count; ++lane)
    if (w.branch[lane]) l.width[lane] = values.width[lane];
}

bool has_outgrown(const Window& w) {
  return w.row ? has_outgrown_row(w) : has_outgrown_network(w);
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

void write(const Window& w, State x) {
  write_outside(w, w.time - w.since, x);
  for (int lane = 0; lane < w.lanes.count; ++lane) {
    const auto& c = w.contact(lane);
    x[c.gap] = 0 - (c.origin + w.lanes.indentation[lane]);  // never −0
    if (c.impulse >= 0) x[c.impulse] = w.x[c.impulse] + w.impulse[lane];
    if (c.work >= 0) x[c.work] = w.x[c.work] + work_of(w, lane, w.lanes.indentation[lane], 0);
  }
  for (std::size_t i = 0; i < w.velocity.size(); ++i) x[place_of(w, static_cast<Index>(i))] = w.velocity[i];
  write_drives(w, 0, x);
}

void write(const Window& w, const Values& values, State x) {
  write_outside(w, w.time + values.time - w.since, x);
  for (int lane = 0; lane < w.lanes.count; ++lane) {
    const auto& c = w.contact(lane);
    x[c.gap] = 0 - (c.origin + values.indentation[lane]);
    if (c.impulse >= 0) x[c.impulse] = w.x[c.impulse] + w.impulse[lane] + impulse_of(w, values, lane);
    if (c.work >= 0) x[c.work] = w.x[c.work] + work_of(w, lane, values.indentation[lane], values.work[lane]);
  }
  write_velocities(w, values, x);
  write_drives(w, values.time, x);
}

}  // namespace mariotte::flow::taylor
