#include "mariotte/impact/impulses.hpp"

#include <algorithm>
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
              const Interval& interval, Index heaviest, std::vector<double>& p) {
  const Index n = layout.velocities();
  p.assign(n - 1, 0.0);
  const auto lost = [&](Index i) { return lost_momentum(chain, layout, interval, i); };
  const auto integral = [&](Index j) {
    return interval.after[layout.impulse[j]] - interval.before[layout.impulse[j]];
  };
  for (Index i = n - 1; i > heaviest; --i)
    p[i - 1] = chain.is_faint[i - 1] ? integral(i - 1) : (i == n - 1 ? 0 : p[i]) - lost(i);
  for (Index j = 0; j < heaviest; ++j)
    p[j] = chain.is_faint[j] ? integral(j) : (j == 0 ? 0 : p[j - 1]) + lost(j);
}

void count_periods(const std::vector<hybrid::Timed<model::ContactChange>>& changes, Index contacts,
                   std::vector<Index>& periods) {
  periods.assign(contacts, 0);
  for (const auto& [time, change] : changes) periods[change.contact] += starts_force(change);
}

void clear_faint(const model::ScaledContacts& contacts, const std::vector<Index>& periods,
                 std::vector<double>& p) {
  for (std::size_t j = 0; j < p.size(); ++j)
    if (periods[j] == 0 || is_faint(contacts, static_cast<Index>(j), p[j])) p[j] = 0;
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
