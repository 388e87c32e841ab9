#include "mariotte/flow/modal/natural_modes.hpp"

#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>

namespace mariotte::flow {
namespace {

constexpr int most_jacobi_sweeps = 40;  ///< a dozen is a lot; a fixed mode may stay in its noise for ever

using Columns = Eigen::Map<Eigen::MatrixXd>;

/// Makes two columns orthogonal; false if they are.
bool rotate(Columns& coupling, Columns& shape, Index p, Index q) {
  const double product = coupling.col(p).dot(coupling.col(q));
  const double left = coupling.col(p).squaredNorm(), right = coupling.col(q).squaredNorm();
  if (std::abs(product) <= 0.5 * epsilon * std::sqrt(left) * std::sqrt(right)) return false;
  Eigen::JacobiRotation<double> rotation;
  rotation.makeJacobi(left, product, right);
  coupling.applyOnTheRight(p, q, rotation);
  shape.applyOnTheRight(p, q, rotation);
  return true;
}

/// Cᵀ, all zeros, and the shapes it starts from.
Columns start(NaturalModes& modes, Index rows, Index springs) {
  modes.frequency.resize(springs);
  modes.shape.resize(springs * springs);
  modes.coupling.assign(rows * springs, 0.0);
  Columns(modes.shape.data(), springs, springs).setIdentity();
  return {modes.coupling.data(), rows, springs};
}

void diagonalize(NaturalModes& modes, Columns& coupling) {
  const Index springs = coupling.cols();
  Columns shape(modes.shape.data(), springs, springs);
  bool turned = true;
  for (int sweep = 0; turned && sweep < most_jacobi_sweeps; ++sweep) {
    turned = false;
    for (Index p = 0; p < springs; ++p)
      for (Index q = p + 1; q < springs; ++q) turned = rotate(coupling, shape, p, q) || turned;
  }
  for (Index i = 0; i < springs; ++i) modes.frequency[i] = coupling.col(i).norm();
}

/// Rounding of a frequency, from those of the springs that take part in its shape.
double noise(const NaturalModes& modes, const std::vector<double>& alone, Index mode) {
  double largest = 0;
  for (std::size_t j = 0; j < alone.size(); ++j)
    largest = std::max(largest, std::abs(modes.at(j, mode)) * alone[j]);
  return 64 * epsilon * largest;
}

}  // namespace

void find(NaturalModes& modes, std::span<const double> inverse_mass, std::span<const double> stiffness) {
  auto coupling = start(modes, std::ssize(inverse_mass), std::ssize(stiffness));
  for (Index j = 0; j < coupling.cols(); ++j) {
    coupling(j, j) = -std::sqrt(stiffness[j]) * std::sqrt(inverse_mass[j]);
    coupling(j + 1, j) = std::sqrt(stiffness[j]) * std::sqrt(inverse_mass[j + 1]);
  }
  diagonalize(modes, coupling);
}

void find(NaturalModes& modes, const LinkedPhase& phase, std::span<const Index> closed) {
  auto coupling = start(modes, phase.dofs, std::ssize(closed));
  std::vector<double> alone;
  for (Index j = 0; j < coupling.cols(); ++j) {
    for (const auto& [dof, coefficient] : phase.half_response[closed[j]])
      coupling(dof, j) += std::sqrt(phase.contact[closed[j]].stiffness) * coefficient;
    alone.push_back(coupling.col(j).norm());
  }
  diagonalize(modes, coupling);
  for (Index i = 0; i < coupling.cols(); ++i)
    if (modes.frequency[i] <= noise(modes, alone, i)) modes.frequency[i] = 0;
}

}  // namespace mariotte::flow
