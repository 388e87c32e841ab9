#include "mariotte/impact/watch/trace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mariotte/impact/watch/thinning.hpp"

namespace mariotte::impact {
namespace {

/// Forces in natural units that differ by less are one.
constexpr double least_jump = 1e-9;

void keep_some(Trace& trace, const std::vector<char>& keep) {
  keep_rows(keep, trace.time, trace.velocity, trace.gap, trace.force);
}

void drop_straightest(Trace& trace) {
  Bends bends(trace.time);
  for (const auto* rows : {&trace.velocity, &trace.force})
    bends.add(rows->front().size(), [&](std::size_t i, std::size_t c) { return (*rows)[i][c]; });
  keep_some(trace, bends.rows_to_keep());
}

}  // namespace

void TraceObserver::begin_phase(double time, ConstState x) {
  cut_rows(rows_until(time * scale_.time, trace_.time), trace_.time, trace_.velocity, trace_.gap,
           trace_.force);
  if (trace_.time.empty() || jumps(x)) keep(time, x);
}

/// Dampers and adhesion push or pull at once where a contact closes, and let go at once.
bool TraceObserver::jumps(ConstState x) const {
  const auto& last = trace_.force.back();
  for (Index j = 0; j < phase_.contacts(); ++j)
    if (std::abs(phase_.felt_force(x, j) - last[j] / scale_.force()) > least_jump) return true;
  return false;
}

void TraceObserver::observe(double start, const flow::Step& step) {
  // A closed form crosses a whole contact in one step: a picture needs points between.
  const double duration = step.end - step.start, fine = phase_.time_scale() / 20;
  const Index pieces = phase_.is_ballistic() ? 1 : static_cast<Index>(std::clamp(duration / fine, 1.0, 64.0));
  std::vector<double> inside(pieces > 1 ? phase_.size() : 0);
  for (Index i = 1; i < pieces; ++i) {
    const double time = step.start + duration * static_cast<double>(i) / static_cast<double>(pieces);
    step.at(time, inside);
    keep(start + time, inside);
  }
  keep(start + step.end, step.after);
}

void TraceObserver::keep(double time, ConstState x) {
  if (trace_.time.size() == capacity) drop_straightest(trace_);
  // Never earlier than the one before, by rounding.
  const double instant = time * scale_.time;
  trace_.time.push_back(trace_.time.empty() ? instant : std::max(instant, trace_.time.back()));
  auto& velocity = trace_.velocity.emplace_back();
  for (Index i = 0; i < phase_.velocities(); ++i) velocity.push_back(phase_.velocity(x, i) * scale_.velocity);
  auto& gap = trace_.gap.emplace_back();
  auto& force = trace_.force.emplace_back();
  for (Index j = 0; j < phase_.contacts(); ++j) {
    gap.push_back(phase_.gap(x, j) * scale_.length);
    force.push_back(phase_.felt_force(x, j) * scale_.force());
  }
}

Trace TraceObserver::take(double time, ConstState x) {
  if (trace_.time.empty() || trace_.time.back() < time * scale_.time) keep(time, x);
  return std::move(trace_);
}

double SampledTrace::take(const Sample& sample) {
  if (interval_ == 0) interval_ = sample.natural_time / 4;
  const double horizon = 4 * sample.crossing_time;
  if (trace_.time.size() >= capacity && sample.time <= horizon) {
    std::vector<char> keep(trace_.time.size());
    for (std::size_t i = 0; i < keep.size(); i += 2) keep[i] = true;
    keep_some(trace_, keep);
    interval_ *= 2;
  }
  trace_.time.push_back(sample.time);
  trace_.velocity.push_back(sample.velocity);
  trace_.gap.push_back(sample.gap);
  trace_.force.push_back(sample.force);
  return sample.time < horizon ? interval_ : sample.time;
}

}  // namespace mariotte::impact
