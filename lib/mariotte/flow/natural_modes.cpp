#include "mariotte/flow/natural_modes.hpp"

#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>

namespace mariotte::flow {
namespace {

constexpr int most_sweeps = 40;  ///< a dozen is a lot; a fixed mode may stay in its noise for ever

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

}  // namespace

void find(NaturalModes& modes, std::span<const double> inverse_mass, std::span<const double> stiffness) {
  const auto springs = static_cast<Index>(stiffness.size());
  modes.frequency.resize(springs);
  modes.shape.resize(springs * springs);
  modes.coupling.resize((springs + 1) * springs);
  Columns coupling(modes.coupling.data(), springs + 1, springs), shape(modes.shape.data(), springs, springs);
  coupling.setZero();
  shape.setIdentity();
  for (Index j = 0; j < springs; ++j) {
    coupling(j, j) = -std::sqrt(stiffness[j]) * std::sqrt(inverse_mass[j]);
    coupling(j + 1, j) = std::sqrt(stiffness[j]) * std::sqrt(inverse_mass[j + 1]);
  }
  bool turned = true;
  for (int sweep = 0; turned && sweep < most_sweeps; ++sweep) {
    turned = false;
    for (Index p = 0; p < springs; ++p)
      for (Index q = p + 1; q < springs; ++q) turned = rotate(coupling, shape, p, q) || turned;
  }
  for (Index i = 0; i < springs; ++i) modes.frequency[i] = coupling.col(i).norm();
}

}  // namespace mariotte::flow
