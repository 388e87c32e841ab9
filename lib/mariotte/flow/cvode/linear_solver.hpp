// Newton matrices for BDF: dense, band or sparse (KLU), filled from the problem's list of entries.
// Private to flow/: it shows SUNDIALS types.
#pragma once
#include <vector>

#include "mariotte/flow/cvode/sundials.hpp"
#include "mariotte/flow/kind.hpp"
#include "mariotte/flow/problem.hpp"

namespace mariotte::flow {

/// A SUNDIALS matrix and its solver for a flow by BDF, with the place of every entry looked up once.
class NewtonMatrix {
 public:
  NewtonMatrix(Kind kind, const Problem& problem, N_Vector like, SUNContext context);

  SUNMatrix matrix() const { return matrix_.get(); }
  SUNLinearSolver solver() const { return solver_.get(); }

  bool fits(const Problem& problem) const { return problem.pattern() == pattern_; }

  /// Write the problem's Jacobian at x into `target`, a matrix of the same kind and shape.
  /// False if an entry is not finite.
  bool fill(const Problem& problem, ConstState x, SUNMatrix target);

 private:
  void make_dense(N_Vector like, SUNContext context);
  void make_band(N_Vector like, SUNContext context);
  void make_sparse(N_Vector like, SUNContext context);

  Index size_;
  Kind kind_;
  std::vector<Entry> pattern_;
  std::vector<Index> place_;                      ///< of each entry in the matrix's data
  std::vector<sunindextype> column_start_, row_;  ///< sparse structure
  std::vector<double> values_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
};

}  // namespace mariotte::flow
