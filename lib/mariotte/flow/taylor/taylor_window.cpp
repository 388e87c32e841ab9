#include "mariotte/flow/taylor/taylor_window.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/taylor/window_parts.hpp"

namespace mariotte::flow::taylor {
namespace {

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
  for (int lane = 0; l.segmented && lane < l.count; ++lane)
    if (w.segment[lane]) w.segment[lane] = &segment_of(w.contact(lane), l.indentation[lane]);
}

bool has_outgrown(const Window& w) {
  return w.row ? has_outgrown_row(w) : has_outgrown_network(w);
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
