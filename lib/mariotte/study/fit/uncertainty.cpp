#include "mariotte/study/fit/uncertainty.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>

#include "mariotte/model/dense.hpp"

namespace mariotte::study {
namespace {

Eigen::Map<const Eigen::MatrixXd> matrix(std::span<const double> columns, Index count) {
  return {columns.data(), std::ssize(columns) / count, count};
}

}  // namespace

std::vector<std::vector<double>> undetermined(std::span<const double> columns, Index count, double tolerance,
                                              double least) {
  if (count == 0) return {};
  const auto [value, right] = model::singular_values({columns, std::ssize(columns) / count});
  std::vector<std::vector<double>> directions;
  for (Index k = 0; k < count; ++k) {
    if (value[k] > std::max(tolerance * value[0], least)) continue;
    const auto column = matrix(right, count).col(k);
    const Eigen::VectorXd direction = column / column.cwiseAbs().maxCoeff();
    directions.emplace_back(direction.begin(), direction.end());
  }
  return directions;
}

Uncertainty uncertainty(std::span<const double> columns, Index count) {
  if (count == 0) return {};
  const auto [value, right] = model::singular_values({columns, std::ssize(columns) / count});
  const Eigen::Map<const Eigen::VectorXd> size(value.data(), count);
  const Eigen::MatrixXd root = matrix(right, count) * size.cwiseInverse().asDiagonal();
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
