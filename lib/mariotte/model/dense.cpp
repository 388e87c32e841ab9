#include "mariotte/model/dense.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace mariotte::model {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Eigen::Map<const Matrix> map(const DenseMatrix& a) {
  return {a.columns.data(), a.rows, std::ssize(a.columns) / a.rows};
}

}  // namespace

struct MinimumNorm::Decomposition {
  Eigen::CompleteOrthogonalDecomposition<Matrix> of;
};

MinimumNorm::MinimumNorm(const DenseMatrix& a)
    : decomposition_(std::make_shared<Decomposition>(
          Decomposition{Eigen::CompleteOrthogonalDecomposition<Matrix>(map(a))})) {}

std::vector<double> MinimumNorm::solve(std::span<const double> b) const {
  const Vector x = decomposition_->of.solve(Eigen::Map<const Vector>(b.data(), std::ssize(b)));
  return {x.begin(), x.end()};
}

SingularValues singular_values(const DenseMatrix& a) {
  const Eigen::BDCSVD<Matrix> svd(map(a), Eigen::ComputeThinV);
  const auto& value = svd.singularValues();
  const auto& right = svd.matrixV();
  return {{value.begin(), value.end()}, {right.data(), right.data() + right.size()}};
}

}  // namespace mariotte::model
