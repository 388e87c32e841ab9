#include "mariotte/report/figure/window.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::report {
namespace {

constexpr double visible = 1e-3, visible_in_image = 1e-2;  // of the largest force
constexpr double strong = 0.05;                            // likewise, beside what pushes all the while
constexpr double brief = 0.02;                             // of all the action
constexpr double long_flight = 3;  // in durations of all the action, or of its longest
constexpr std::size_t most_windows = 3;
constexpr double margin = 0.1;  // of what is shown

double largest(const std::vector<double>& row) {
  double most = 0;
  for (const double value : row) most = std::max(most, std::abs(value));
  return most;
}

/// Stretches of samples with a force above `least`, from the sample before, after which the force began.
std::vector<Window> stretches(const std::vector<double>& time, const std::vector<double>& force,
                              double least) {
  std::vector<Window> all;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!(force[i] > least)) continue;
    if (i == 0 || !(force[i - 1] > least)) all.push_back({time[i > 0 ? i - 1 : 0], time[i]});
    all.back().end = time[i];
  }
  return all;
}

double duration(const std::vector<Window>& windows) {
  double sum = 0;
  for (const auto& one : windows) sum += one.end - one.start;
  return sum;
}

double longest(const std::vector<Window>& windows) {
  double most = 0;
  for (const auto& one : windows) most = std::max(most, one.end - one.start);
  return most;
}

/// Those between which lies no flight longer than `gap`, joined.
std::vector<Window> joined(const std::vector<Window>& stretches, double gap) {
  std::vector<Window> all;
  for (const auto& one : stretches)
    if (all.empty() || one.start - all.back().end > gap)
      all.push_back(one);
    else
      all.back().end = one.end;
  return all;
}

/// With some room before and behind, and a short flight before the first.
std::vector<Window> widened(std::vector<Window> all, const std::vector<double>& time) {
  const double room = margin * duration(all) / static_cast<double>(all.size());
  const double first = all.front().start < duration(all) ? time.front() : all.front().start - room;
  for (auto& one : all) one = {std::max(one.start - room, first), std::min(one.end + room, time.back())};
  all.front().start = first;
  return all;
}

/// As many as are shown, in the order of time.
std::vector<Window> strongest(std::vector<Window> all, const std::vector<double>& time,
                              const std::vector<double>& force) {
  const auto peak = [&](const Window& one) {
    double most = 0;
    for (std::size_t i = 0; i < time.size(); ++i)
      if (time[i] >= one.start && time[i] <= one.end) most = std::max(most, force[i]);
    return most;
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Window& a, const Window& b) { return peak(a) > peak(b); });
  all.resize(std::min(all.size(), most_windows));
  std::sort(all.begin(), all.end(), [](const Window& a, const Window& b) { return a.start < b.start; });
  return all;
}

/// Those far apart, and how many they are.
Action strongest_of(const std::vector<Window>& parts, Window whole, const std::vector<double>& time,
                    const std::vector<double>& force) {
  const auto impacts = joined(parts, long_flight * longest(parts));
  return {widened({whole}, time), widened(strongest(impacts, time, force), time), impacts.size()};
}

Action action(const std::vector<double>& time, const std::vector<double>& force, double least = visible) {
  const auto parts = stretches(time, force, least * largest(force));
  const auto all = joined(parts, long_flight * duration(parts));
  if (duration(all) == 0) return {.windows = {{time.front(), time.back()}}, .strongest = {}};
  const Window whole{all.front().start, all.back().end};
  if (all.size() > most_windows) return strongest_of(parts, whole, time, force);
  const auto pulses = stretches(time, force, strong * largest(force));
  if (all.size() == 1 && duration(pulses) < brief * duration(all))
    return strongest_of(pulses, whole, time, force);
  return {widened(all, time), {}, all.size()};
}

}  // namespace

Action action_of(const impact::Trace& trace) {
  std::vector<double> force;
  for (const auto& row : trace.force) force.push_back(largest(row));
  const bool is_image = !trace.force.empty() && trace.force.front().size() > most_curves;
  return action(trace.time, force, is_image ? visible_in_image : visible);
}

Action action_of(const impact::BodyTrace& trace) {
  std::vector<double> time, force;
  for (std::size_t i = 0; i < trace.state.size(); ++i) {
    time.push_back(trace.state[i].time);
    force.push_back(largest(trace.normal_force[i]));
  }
  return action(time, force);
}

}  // namespace mariotte::report
