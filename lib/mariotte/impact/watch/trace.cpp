#include "mariotte/impact/watch/trace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mariotte::impact {
namespace {

using Rows = std::vector<std::vector<double>>;

template <class Keeps>
void keep_some(Trace& trace, Keeps&& keeps) {
  const auto shrink = [&](auto& rows) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (keeps(i) && kept++ < i) rows[kept - 1] = std::move(rows[i]);
    rows.resize(kept);
  };
  shrink(trace.time);
  shrink(trace.velocity);
  shrink(trace.gap);
  shrink(trace.force);
}

/// Of each column.
std::vector<double> largest(const Rows& rows) {
  std::vector<double> most(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) most[c] = std::max(most[c], std::abs(row[c]));
  return most;
}

/// How far row i is from the line between its neighbours, relative to the largest of the column.
double bend(const std::vector<double>& time, const Rows& rows, const std::vector<double>& most,
            std::size_t i) {
  const double whole = time[i + 1] - time[i - 1], share = whole > 0 ? (time[i] - time[i - 1]) / whole : 0.5;
  double farthest = 0;
  for (std::size_t c = 0; c < most.size(); ++c) {
    const double expected = rows[i - 1][c] + share * (rows[i + 1][c] - rows[i - 1][c]);
    if (most[c] > 0) farthest = std::max(farthest, std::abs(rows[i][c] - expected) / most[c]);
  }
  return farthest;
}

/// No two neighbours are dropped at once.
void drop_straightest(Trace& trace) {
  const auto fastest = largest(trace.velocity), strongest = largest(trace.force);
  std::vector<double> bends(trace.time.size(), infinity), sorted;
  for (std::size_t i = 1; i + 1 < bends.size(); i += 2) {
    bends[i] =
        std::max(bend(trace.time, trace.velocity, fastest, i), bend(trace.time, trace.force, strongest, i));
    sorted.push_back(bends[i]);
  }
  const auto middle = sorted.begin() + std::ssize(sorted) / 2;
  std::nth_element(sorted.begin(), middle, sorted.end());
  keep_some(trace, [&](std::size_t i) { return bends[i] > *middle; });
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
    keep(start + time, inside);
  }
  keep(start + step.end, step.after);
}

void TraceObserver::keep(double time, ConstState x) {
  if (trace_.time.size() == capacity) drop_straightest(trace_);
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

double SampledTrace::take(const Sample& sample) {
  if (interval_ == 0) interval_ = sample.natural_time / 4;
  const double horizon = 4 * sample.crossing_time;
  if (trace_.time.size() >= capacity && sample.time <= horizon) {
    keep_some(trace_, [](std::size_t i) { return i % 2 == 0; });
    interval_ *= 2;
  }
  trace_.time.push_back(sample.time);
  trace_.velocity.push_back(sample.velocity);
  trace_.gap.push_back(sample.gap);
  trace_.force.push_back(sample.force);
  return sample.time < horizon ? interval_ : sample.time;
}

}  // namespace mariotte::impact
