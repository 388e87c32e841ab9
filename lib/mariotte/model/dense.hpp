// Decompositions of dense matrices, by Eigen. Each takes the compiler long; so all that need one share this.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::model {

/// A matrix somewhere else, column by column.
struct DenseMatrix {
  std::span<const double> columns;
  Index rows;
};

/// Of all x with the least |A x − b| the shortest, also where A has not full rank.
class MinimumNorm {
 public:
  explicit MinimumNorm(const DenseMatrix& a);
  std::vector<double> solve(std::span<const double> b) const;

 private:
  struct Decomposition;
  std::shared_ptr<const Decomposition> decomposition_;
};

/// Of A = U Σ Vᵀ.
struct SingularValues {
  std::vector<double> value;  ///< falling
  std::vector<double> right;  ///< V, one column for each value
};

SingularValues singular_values(const DenseMatrix& a);

}  // namespace mariotte::model
