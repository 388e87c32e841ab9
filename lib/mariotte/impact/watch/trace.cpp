#include "mariotte/impact/watch/trace.hpp"

#include <algorithm>
#include <utility>

namespace mariotte::impact {
namespace {

template <class Row>
void drop_every_other(std::vector<Row>& rows) {
  for (std::size_t i = 1; 2 * i < rows.size(); ++i) rows[i] = std::move(rows[2 * i]);
  rows.resize((rows.size() + 1) / 2);
}

void thin(Trace& trace) {
  drop_every_other(trace.time);
  drop_every_other(trace.velocity);
  drop_every_other(trace.gap);
  drop_every_other(trace.force);
}

}  // namespace

void TraceObserver::observe(double start, const flow::Step& step) {
  if (trace_.time.empty()) keep(start + step.start, step.before);
  // A closed form crosses a whole contact in one step: a picture needs points between.
  const double duration = step.end - step.start, fine = phase_.time_scale() / 20;
  const Index pieces = phase_.is_ballistic() ? 1 : static_cast<Index>(std::clamp(duration / fine, 1.0, 64.0));
  std::vector<double> inside(pieces > 1 ? phase_.size() : 0);
  for (Index i = 1; i < pieces; ++i) {
    const double time = step.start + duration * static_cast<double>(i) / static_cast<double>(pieces);
    step.at(time, inside);
    offer(start + time, inside);
  }
  offer(start + step.end, step.after);
}

void TraceObserver::offer(double time, ConstState x) {
  if (++offered_ % stride_ == 0) keep(time, x);
}

void TraceObserver::keep(double time, ConstState x) {
  if (trace_.time.size() == capacity) thin();
  trace_.time.push_back(time * scale_.time);
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

void TraceObserver::thin() {
  impact::thin(trace_);
  stride_ *= 2;
}

double SampledTrace::take(const Sample& sample) {
  if (interval_ == 0) interval_ = sample.natural_time / 4;
  const double horizon = 4 * sample.crossing_time;
  if (trace_.time.size() >= capacity && sample.time <= horizon) {
    thin(trace_);
    interval_ *= 2;
  }
  trace_.time.push_back(sample.time);
  trace_.velocity.push_back(sample.velocity);
  trace_.gap.push_back(sample.gap);
  trace_.force.push_back(sample.force);
  return sample.time < horizon ? interval_ : sample.time;
}

}  // namespace mariotte::impact
