#include "mariotte/model/contacts/bound.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mariotte/core/bracket.hpp"
#include "mariotte/model/dense.hpp"

namespace mariotte::model {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A contact in its well: energies where it is, where it opens, and where it rests.
struct Well {
  double now, barrier, least;
  double opening, rest;
};

double potential(const HeldContact& c, double indentation) {
  return c.law->stored_energy(c.past, indentation) - c.pull * indentation;
}
double force(const HeldContact& c, double indentation) {
  return c.law->force(c.past, indentation, 0).value - c.pull;
}

/// Where a function that is negative at `low` becomes positive, beyond it; from the smallest step on.
template <class Function>
double where_positive(Function&& f, double low, double step) {
  constexpr int doublings = 400;
  double high = low + step, before = low;
  for (int i = 0; i < doublings && !(f(high) > 0); ++i) {
    before = high;
    high = low + (step *= 2);
  }
  return locate_sign_change(f, before, f(before), high, f(high), 1e-14 * (high - low));
}

double rest_of(const HeldContact& c, double opening) {
  if (const auto known = c.pull == 0 ? c.law->rest_indentation(c.past) : std::nullopt) return *known;
  constexpr double small = 1e-60;  // below any length, in whatever unit
  const double step = std::max(0.01 * std::abs(opening), small);
  return where_positive([&](double d) { return force(c, d); }, opening, step);
}

Well well_of(const HeldContact& c) {
  const double opening = c.law->opening_indentation(c.past), rest = rest_of(c, opening);
  return {.now = potential(c, c.indentation),
          .barrier = potential(c, opening),
          .least = potential(c, rest),
          .opening = opening,
          .rest = rest};
}

Eigen::Map<const VectorXd> vector(const std::vector<double>& numbers) {
  return {numbers.data(), std::ssize(numbers)};
}
MatrixXd matrix(const HeldTogether& all) {
  const auto n = std::ssize(all.held);
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      all.coupling.data(), n, n);
}

/// Contacts that move each other have one number.
std::vector<Index> clusters(const MatrixXd& a) {
  std::vector<Index> cluster(static_cast<std::size_t>(a.rows()));
  for (Index i = 0; i < a.rows(); ++i) cluster[i] = i;
  for (Index i = 0; i < a.rows(); ++i)
    for (Index k = 0; k < i; ++k)
      if (a(i, k) != 0 && cluster[i] != cluster[k])
        std::replace(cluster.begin(), cluster.end(), cluster[i], cluster[k]);
  return cluster;
}

/// How far the indentation of a contact in its well can change with an energy above the least of all.
double range(const HeldContact& c, const Well& well, double energy) {
  const double top = where_positive([&](double d) { return potential(c, d) - well.least - energy; },
                                    well.rest, well.rest - well.opening);
  return top - well.opening;
}

/// A contact with the energy that its own rate needs at least, if others give it none: quickly told.
bool could_open(const HeldContact& c, double reduced_mass) {
  const double energy = potential(c, c.indentation) + 0.5 * reduced_mass * c.rate * c.rate;
  return !(energy < potential(c, c.law->opening_indentation(c.past)));
}

}  // namespace

double well_energy(const contact::Law& law) {
  if (!contact::adheres(law)) return 0;
  const HeldContact fresh{
      .contact = 0, .law = contact::branched(law), .past = {}, .indentation = 0, .rate = 0};
  return std::max(0.0, -well_of(fresh).least);
}

bool is_bound(const HeldTogether& all) {
  const auto n = std::ssize(all.held);
  if (n == 0) return false;
  const auto is_pressed = [](const HeldContact& c) { return c.pull != 0; };
  if (n > 1 && std::any_of(all.held.begin(), all.held.end(), is_pressed)) return false;
  for (Index j = 0; j < n; ++j)
    if (could_open(all.held[j], 1 / all.coupling[j * n + j])) return false;
  const MinimumNorm solver({all.coupling, n});  // the coupling is symmetric
  std::vector<double> rate;
  for (const auto& one : all.held) rate.push_back(one.rate);
  const auto momentum = solver.solve(rate);
  const auto cluster = clusters(matrix(all));
  std::vector<Well> wells;
  for (const auto& one : all.held) wells.push_back(well_of(one));
  VectorXd ranges(n);
  for (Index j = 0; j < n; ++j) {
    double excess = 0;  // of the cluster, above the least it can store
    for (Index k = 0; k < n; ++k)
      if (cluster[k] == cluster[j]) excess += 0.5 * rate[k] * momentum[k] + wells[k].now - wells[k].least;
    if (!(excess < wells[j].barrier - wells[j].least)) return false;
    ranges[j] = range(all.held[j], wells[j], excess);
  }
  return std::all_of(all.loose.begin(), all.loose.end(), [&](const LooseContact& open) {
    const double drift = open.approach - vector(open.coupling).dot(vector(momentum));
    const auto lever = solver.solve(open.coupling);
    return drift <= all.noise_speed && open.clearance >= vector(lever).cwiseAbs().dot(ranges);
  });
}

std::vector<LackedSpeed> lacked_speeds(const HeldTogether& all) {
  std::vector<LackedSpeed> list;
  const std::size_t count = all.held.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto& one = all.held[i];
    const double softness = all.coupling[i * count + i];  // inverse of the reduced mass
    const double barrier = potential(one, one.law->opening_indentation(one.past));
    const double square = 2 * softness * (barrier - potential(one, one.indentation)) - one.rate * one.rate;
    if (square > 0) list.push_back({one.contact, std::sqrt(square)});
  }
  return list;
}

std::vector<double> ringing(const HeldTogether& all) {
  const auto n = std::ssize(all.held);
  if (n == 0) return {};
  VectorXd stiffness(n);
  for (Index j = 0; j < n; ++j)
    stiffness[j] = all.held[j].law->force(all.held[j].past, well_of(all.held[j]).rest, 0).by_indentation;
  const VectorXd root = stiffness.cwiseSqrt();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(root.asDiagonal() * matrix(all) * root.asDiagonal(),
                                                      Eigen::EigenvaluesOnly);
  std::vector<double> frequency;
  for (const double square : modes.eigenvalues()) frequency.push_back(std::sqrt(std::max(0.0, square)));
  return frequency;
}

}  // namespace mariotte::model
