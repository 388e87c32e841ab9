#include "mariotte/report/figure/window.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::report {
namespace {

constexpr double visible = 1e-3, visible_in_image = 1e-2;  // of the largest force
constexpr double long_flight = 3;                          // in durations of all the action
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

/// Those between which no long flight lies, joined.
std::vector<Window> joined(const std::vector<Window>& stretches) {
  const double gap = long_flight * duration(stretches);
  std::vector<Window> all;
  for (const auto& one : stretches)
    if (all.empty() || one.start - all.back().end > gap)
      all.push_back(one);
    else
      all.back().end = one.end;
  return all;
}

std::vector<Window> windows(const std::vector<double>& time, const std::vector<double>& force,
                            double least = visible) {
  auto all = joined(stretches(time, force, least * largest(force)));
  if (duration(all) == 0) return {{time.front(), time.back()}};
  if (all.size() > most_windows) all = {{all.front().start, all.back().end}};
  const double room = margin * duration(all) / static_cast<double>(all.size());
  const double first = all.front().start < duration(all) ? time.front() : all.front().start - room;
  for (auto& one : all) one = {std::max(one.start - room, first), std::min(one.end + room, time.back())};
  all.front().start = first;
  return all;
}

}  // namespace

std::vector<Window> windows_of_action(const impact::Trace& trace) {
  std::vector<double> force;
  for (const auto& row : trace.force) force.push_back(largest(row));
  const bool is_image = !trace.force.empty() && trace.force.front().size() > most_curves;
  return windows(trace.time, force, is_image ? visible_in_image : visible);
}

std::vector<Window> windows_of_action(const impact::BodyTrace& trace) {
  std::vector<double> time, force;
  for (std::size_t i = 0; i < trace.state.size(); ++i) {
    time.push_back(trace.state[i].time);
    force.push_back(largest(trace.normal_force[i]));
  }
  return windows(time, force);
}

}  // namespace mariotte::report
