#include "mariotte/study/fit/uncertainty.hpp"

#include <Eigen/Dense>
#include <boost/math/distributions/students_t.hpp>

namespace mariotte::study {
namespace {

using Slopes = Eigen::Map<const Eigen::MatrixXd>;

Slopes matrix(std::span<const double> columns, Index count) {
  return {columns.data(), std::ssize(columns) / count, count};
}

}  // namespace

std::vector<std::vector<double>> undetermined(std::span<const double> columns, Index count,
                                              double tolerance) {
  if (count == 0) return {};
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix(columns, count), Eigen::ComputeThinV);
  std::vector<std::vector<double>> directions;
  for (Index k = 0; k < count; ++k) {
    if (svd.singularValues()(k) > tolerance * svd.singularValues()(0)) continue;
    const Eigen::VectorXd direction = svd.matrixV().col(k) / svd.matrixV().col(k).cwiseAbs().maxCoeff();
    directions.emplace_back(direction.begin(), direction.end());
  }
  return directions;
}

Uncertainty uncertainty(std::span<const double> columns, Index count) {
  if (count == 0) return {};
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix(columns, count), Eigen::ComputeThinV);
  const Eigen::MatrixXd root = svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal();
  const Eigen::MatrixXd covariance = root * root.transpose();
  const Eigen::VectorXd error = covariance.diagonal().cwiseSqrt();
  Uncertainty found{.standard_error = {error.begin(), error.end()}, .correlation = {}};
  for (Index i = 0; i < count; ++i) {
    auto& row = found.correlation.emplace_back();
    for (Index j = 0; j < count; ++j) row.push_back(i == j ? 1 : covariance(i, j) / (error(i) * error(j)));
  }
  return found;
}

double student_t(double confidence, Index degrees_of_freedom) {
  // In plain double: tables of long double are made when the program starts, which valgrind cannot do.
  using Plain = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  const boost::math::students_t_distribution<double, Plain> distribution(
      static_cast<double>(degrees_of_freedom));
  return quantile(complement(distribution, 0.5 * (1 - confidence)));
}

}  // namespace mariotte::study
