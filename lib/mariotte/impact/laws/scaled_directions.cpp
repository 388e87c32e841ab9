// What a configuration tells by its scaled directions A = L⁻¹ Gᵀ, with M = L Lᵀ.
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <optional>

#include "mariotte/impact/laws/configuration.hpp"
#include "mariotte/model/dense.hpp"

namespace mariotte::impact {
namespace {

using Numbers = std::vector<double>;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double shift = 1e-12;       // far more than rounding makes of redundant contacts
constexpr double negligible = 1e-12;  // of |y|
constexpr int most_turns = 20;        // most networks need two or three

/// A, n × m.
Sparse scaled_directions(const Configuration& c) {
  const Index dofs = std::ssize(c.velocity), contacts = std::ssize(c.contact);
  std::vector<ContactDirection> columns;
  model::half_responses(c.mass, c.contact, dofs, columns);
  std::vector<Eigen::Triplet<double>> places;
  for (Index j = 0; j < contacts; ++j)
    for (const auto& [dof, coefficient] : columns[j])
      places.emplace_back(static_cast<int>(dof), static_cast<int>(j), coefficient);
  Sparse scaled(dofs, contacts);
  scaled.setFromTriplets(places.begin(), places.end());
  return scaled;
}

/// The shortest y with Aᵀ y = w, for columns of length 1; if no y has these w, that of the nearest ones.
class ShortestSolution {
 public:
  explicit ShortestSolution(const Sparse& a) : a_(a) {
    shifted_.setShift(shift);
    shifted_.compute(a.transpose() * a);
  }

  Vector of(const Vector& w) const {
    if (const auto y = by_turns(w)) return *y;
    const Matrix turned(a_.transpose());
    const model::MinimumNorm solver(
        {{turned.data(), static_cast<std::size_t>(turned.size())}, turned.rows()});
    const auto y = solver.solve({w.data(), static_cast<std::size_t>(w.size())});
    return Eigen::Map<const Vector>(y.data(), std::ssize(y));
  }

 private:
  /// y grows by A p of p = (AᵀA + shift)⁻¹ (w − Aᵀ y), a sum of columns as the shortest solution is. A part
  /// of singular value σ shrinks to shift/(shift + σ²) of what it lacks; where σ is 0 nothing is lacking, and
  /// p is rounding. Nothing if y does not settle: σ² of some part is about the shift, or no y has these w and
  /// p is so large that y is rounding.
  std::optional<Vector> by_turns(const Vector& w) const {
    Vector y = Vector::Zero(a_.rows());
    for (int turn = 0; turn < most_turns; ++turn) {
      const Vector p = shifted_.solve(w - a_.transpose() * y);
      const Vector change = a_ * p;
      y += change;
      if (std::max(change.norm(), epsilon * p.norm()) <= negligible * y.norm()) return y;
    }
    return std::nullopt;
  }

  const Sparse& a_;
  Eigen::SimplicialLDLT<Sparse> shifted_;
};

}  // namespace

Numbers compliance(const Configuration& c) {
  const auto a = scaled_directions(c);
  const Matrix product = Matrix(a.transpose() * a);
  return {product.data(), product.data() + product.size()};
}

double relative_energy(const Configuration& c, const Numbers& velocity) {
  return relative_energies(c, {velocity})[0];
}

Numbers relative_energies(const Configuration& c, const std::vector<Numbers>& velocities) {
  auto a = scaled_directions(c);
  Vector unit(a.cols());
  for (Index j = 0; j < a.cols(); ++j) {
    const double length = a.col(j).norm();
    unit[j] = length > 0 ? 1 / length : 0;  // between walls no impulse changes anything
  }
  a = a * unit.asDiagonal();
  const ShortestSolution shortest(a);
  Numbers energies;
  for (const auto& velocity : velocities) {
    const auto rates = gap_rates(c, velocity);
    const Eigen::Map<const Vector> w(rates.data(), a.cols());
    energies.push_back(0.5 * shortest.of(w.cwiseProduct(unit)).squaredNorm());
  }
  return energies;
}

}  // namespace mariotte::impact
