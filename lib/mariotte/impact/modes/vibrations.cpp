#include "mariotte/impact/modes/vibrations.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "mariotte/impact/modes/directions.hpp"
#include "mariotte/model/dense.hpp"

namespace mariotte::impact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Index moving_dofs(const model::Network& network) {
  const Index dofs = std::ssize(network.velocity);
  if (!model::is_diagonal(network.mass, dofs)) return dofs;
  return std::count_if(network.mass.begin(), network.mass.end(), [](double m) { return std::isfinite(m); });
}

std::vector<double> scaled_to_one(const VectorXd& shape) {
  Index largest = 0;
  shape.cwiseAbs().maxCoeff(&largest);
  const VectorXd scaled = shape / shape[largest];
  return {scaled.begin(), scaled.end()};
}

bool are_equal(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(a);
}

/// Masses of balls, and stiffnesses between them, without walls.
struct Lattice {
  std::vector<double> mass, stiffness;
};
Lattice lattice(const model::Chain& chain, const Rest& rest) {
  Lattice all;
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    if (std::isinf(chain.mass[i])) continue;
    all.mass.push_back(chain.mass[i]);
    if (i > 0 && std::isfinite(chain.mass[i - 1])) all.stiffness.push_back(rest.stiffness[i - 1]);
  }
  return all;
}

bool repeats(const std::vector<double>& values, std::size_t period) {
  for (std::size_t i = period; i < values.size(); ++i)
    if (!are_equal(values[i], values[i - period])) return false;
  return true;
}

}  // namespace

Vibrations vibrations(const model::Network& network, const Rest& rest) {
  const Index dofs = std::ssize(network.velocity), contacts = std::ssize(rest.stiffness);
  const VectorXd root = Eigen::Map<const VectorXd>(rest.stiffness.data(), contacts).cwiseSqrt();
  const auto matrix = [&](const std::vector<double>& columns) -> MatrixXd {
    return Eigen::Map<const MatrixXd>(columns.data(), dofs, contacts) * root.asDiagonal();
  };
  const MatrixXd half = matrix(half_directions(network));
  const MatrixXd response = matrix(dense(model::responses(network.mass, network.direction, dofs), dofs));
  const auto [value, right] =
      model::singular_values({{half.data(), static_cast<std::size_t>(half.size())}, dofs});
  const Eigen::Map<const MatrixXd> shape(right.data(), contacts, std::ssize(value));
  Vibrations all;
  const double noise = static_cast<double>(std::max(dofs, contacts)) * epsilon * value[0];
  for (Index i = std::ssize(value) - 1; i >= 0; --i) {
    if (value[i] <= noise) continue;
    all.frequency.push_back(value[i]);
    all.shape.push_back(scaled_to_one(response * shape.col(i)));
  }
  all.rigid_motions = moving_dofs(network) - std::ssize(all.frequency);
  return all;
}

Vibrations vibrations(const model::Chain& chain, const Rest& rest) {
  auto weightless = chain;
  weightless.gravity = 0;
  return vibrations(as_network(weightless), rest);
}

std::optional<BandEdges> band_edges(const model::Chain& chain, const Rest& rest) {
  const auto [mass, stiffness] = lattice(chain, rest);
  if (stiffness.empty() || !repeats(mass, 2) || !repeats(stiffness, 1)) return std::nullopt;
  const double k = stiffness[0], light = std::min(mass[0], mass[1]), heavy = std::max(mass[0], mass[1]);
  if (are_equal(light, heavy)) return BandEdges{.acoustic_top = 2 * std::sqrt(k / light)};
  return BandEdges{.acoustic_top = std::sqrt(2 * k / heavy),
                   .optical_bottom = std::sqrt(2 * k / light),
                   .optical_top = std::sqrt(2 * k * (1 / light + 1 / heavy))};
}

}  // namespace mariotte::impact
