#include "mariotte/impact/impulses.hpp"

#include <cmath>

namespace mariotte::impact {
namespace {

/// ∫ of the given force on ball i.
double given_impulse(const model::DimensionlessChain& chain, Index i, double time) {
  double sum = 0;
  for (const auto& drive : chain.drive)
    for (const auto& [ball, coefficient] : drive.direction)
      if (drive.is_force && ball == i) sum += coefficient * integral(drive.signal, time);
  return sum;
}

/// Momentum that ball i has lost to its contacts.
double lost_momentum(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                     const Interval& interval, Index i) {
  const Index v = layout.velocity[i];
  return chain.mass[i] * (interval.before[v] - interval.after[v] - chain.gravity[i] * interval.time) +
         given_impulse(chain, i, interval.time);
}

}  // namespace

void impulses(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
              const Interval& interval, std::vector<double>& p) {
  const Index n = layout.velocities();
  p.assign(n - 1, 0.0);
  const auto is_wall = [&](Index i) { return chain.inverse_mass[i] == 0; };
  Index right_end = n - 1;  // the trailing balls up to the last wall are summed from the free right end
  for (; right_end > 0 && !is_wall(right_end); --right_end) {
    p[right_end - 1] =
        (right_end == n - 1 ? 0 : p[right_end]) - lost_momentum(chain, layout, interval, right_end);
  }
  if (right_end == 0 && !is_wall(0)) right_end = n;  // no wall: from the left, as the ratios read
  for (Index j = 0; j + 1 < n && j < right_end; ++j) {
    if (is_wall(j))
      p[j] = interval.after[layout.impulse[j]] - interval.before[layout.impulse[j]];
    else
      p[j] = (j == 0 ? 0 : p[j - 1]) + lost_momentum(chain, layout, interval, j);
  }
}

void count_periods(const std::vector<hybrid::Timed<model::ContactChange>>& changes, Index contacts,
                   std::vector<Index>& periods) {
  periods.assign(contacts, 0);
  for (const auto& [time, change] : changes) periods[change.contact] += starts_force(change);
}

void clear_untouched(const std::vector<Index>& periods, std::vector<double>& p) {
  for (std::size_t j = 0; j < p.size(); ++j)
    if (periods[j] == 0) p[j] = 0;
}

std::optional<double> correlation_ratio(const std::vector<double>& impulses, std::size_t j) {
  if (j + 1 >= impulses.size() || impulses[j + 1] == 0) return std::nullopt;
  return impulses[j] / impulses[j + 1];
}

std::vector<std::optional<double>> correlation_ratios(const std::vector<double>& impulses) {
  std::vector<std::optional<double>> ratios;
  for (std::size_t j = 0; j + 1 < impulses.size(); ++j) ratios.push_back(correlation_ratio(impulses, j));
  return ratios;
}

double magnitude(const std::vector<double>& impulses) {
  double length = 0;
  for (const double p : impulses) length = std::hypot(length, p);
  return length;
}

std::vector<double> direction(const std::vector<double>& impulses) {
  const double length = magnitude(impulses);
  auto r = impulses;
  if (length > 0)
    for (double& component : r) component /= length;
  return r;
}

}  // namespace mariotte::impact
