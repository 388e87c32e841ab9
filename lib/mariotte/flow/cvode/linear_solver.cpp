#include "mariotte/flow/cvode/linear_solver.hpp"

#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <cmath>

namespace mariotte::flow {

NewtonMatrix::NewtonMatrix(Kind kind, const Problem& problem, N_Vector like, SUNContext context)
    : size_(problem.size()), kind_(kind), pattern_(problem.pattern()), values_(pattern_.size()) {
  if (kind == Kind::cvode_bdf_dense)
    make_dense(like, context);
  else if (kind == Kind::cvode_bdf_band)
    make_band(like, context);
  else
    make_sparse(like, context);
}

void NewtonMatrix::make_dense(N_Vector like, SUNContext context) {
  matrix_.reset(SUNDenseMatrix(size_, size_, context));
  solver_.reset(SUNLinSol_Dense(like, matrix_.get(), context));
  for (const auto& [row, column] : pattern_) place_.push_back(column * size_ + row);
}

void NewtonMatrix::make_band(N_Vector like, SUNContext context) {
  Index above = 0, below = 0;
  for (const auto& [row, column] : pattern_) {
    above = std::max(above, column - row);
    below = std::max(below, row - column);
  }
  matrix_.reset(SUNBandMatrix(size_, above, below, context));
  solver_.reset(SUNLinSol_Band(like, matrix_.get(), context));
  const Index stored_above = SM_SUBAND_B(matrix_.get()), stride = SM_LDIM_B(matrix_.get());
  for (const auto& [row, column] : pattern_) place_.push_back(column * stride + row - column + stored_above);
}

void NewtonMatrix::make_sparse(N_Vector like, SUNContext context) {
  // Compressed columns; Newton's matrix I − γJ needs the diagonal whether or not J has it.
  std::vector<std::vector<sunindextype>> rows(size_);
  for (Index i = 0; i < size_; ++i) rows[i].push_back(i);
  for (const auto& [row, column] : pattern_) rows[column].push_back(row);
  column_start_.push_back(0);
  for (auto& column : rows) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    row_.insert(row_.end(), column.begin(), column.end());
    column_start_.push_back(static_cast<sunindextype>(row_.size()));
  }
  for (const auto& [row, column] : pattern_) {
    const auto first = row_.begin() + column_start_[column], last = row_.begin() + column_start_[column + 1];
    place_.push_back(std::lower_bound(first, last, row) - row_.begin());
  }
  matrix_.reset(SUNSparseMatrix(size_, size_, static_cast<sunindextype>(row_.size()), CSC_MAT, context));
  std::copy(column_start_.begin(), column_start_.end(), SM_INDEXPTRS_S(matrix_.get()));
  std::copy(row_.begin(), row_.end(), SM_INDEXVALS_S(matrix_.get()));
  solver_.reset(SUNLinSol_KLU(like, matrix_.get(), context));
}

bool NewtonMatrix::fill(const Problem& problem, ConstState x, SUNMatrix target) {
  problem.jacobian(x, values_);
  SUNMatZero(target);
  double* const data = kind_ == Kind::cvode_bdf_dense  ? SM_DATA_D(target)
                       : kind_ == Kind::cvode_bdf_band ? SM_DATA_B(target)
                                                       : SM_DATA_S(target);
  if (kind_ == Kind::cvode_bdf_klu) {
    std::copy(column_start_.begin(), column_start_.end(), SM_INDEXPTRS_S(target));
    std::copy(row_.begin(), row_.end(), SM_INDEXVALS_S(target));
  }
  for (std::size_t i = 0; i < place_.size(); ++i) data[place_[i]] += values_[i];
  return std::all_of(values_.begin(), values_.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace mariotte::flow
