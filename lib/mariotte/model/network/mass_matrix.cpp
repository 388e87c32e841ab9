#include "mariotte/model/network/mass_matrix.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::model {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

Eigen::Map<const Matrix> full(const MassMatrix& mass, Index dofs) {
  return {mass.data(), dofs, dofs};
}

void expect(bool holds, const char* rule) {
  if (!holds) throw InvalidParameter(rule);
}

void validate_mass(const MassMatrix& mass, Index dofs) {
  if (is_diagonal(mass, dofs)) {
    for (const double m : mass) expect(m > 0, "every mass must be positive");
    return;
  }
  expect(std::ssize(mass) == dofs * dofs,
         "the mass matrix needs one value per degree of freedom, or all rows");
  expect(std::all_of(mass.begin(), mass.end(), [](double m) { return std::isfinite(m); }),
         "a full mass matrix must be finite");
  const auto m = full(mass, dofs);
  expect((m - m.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * m.cwiseAbs().maxCoeff(),  // as written by hand
         "the mass matrix must be symmetric");
  expect(Eigen::LLT<Matrix>(m).info() == Eigen::Success, "the mass matrix must be positive definite");
}

/// As many empty columns as there are contacts; those that stay keep their memory.
void empty_columns(std::size_t count, std::vector<ContactDirection>& columns) {
  columns.resize(count);
  for (auto& column : columns) column.clear();
}

/// The directions with each coefficient over its dof's divisor.
template <class Divisor>
void divide(const std::vector<ContactDirection>& contact, Divisor&& divisor,
            std::vector<ContactDirection>& quotient) {
  empty_columns(contact.size(), quotient);
  for (std::size_t j = 0; j < contact.size(); ++j)
    for (const auto& [dof, coefficient] : contact[j])
      if (coefficient != 0 && std::isfinite(divisor(dof)))
        quotient[j].push_back({dof, coefficient / divisor(dof)});
}

/// The directions, each as a full column, after `solve` has changed it in place.
template <class Solve>
void solve_columns(const std::vector<ContactDirection>& contact, Index dofs, Solve&& solve,
                   std::vector<ContactDirection>& solution) {
  empty_columns(contact.size(), solution);
  Vector column(dofs);
  for (std::size_t j = 0; j < contact.size(); ++j) {
    column.setZero();
    for (const auto& [dof, coefficient] : contact[j]) column[dof] += coefficient;
    solve(column);
    for (Index i = 0; i < dofs; ++i)
      if (column[i] != 0) solution[j].push_back({i, column[i]});
  }
}

}  // namespace

void validate(const MassMatrix& mass, const std::vector<ContactDirection>& contact, Index dofs) {
  for (const auto& direction : contact)
    for (const auto& [dof, coefficient] : direction) {
      expect(dof >= 0 && dof < dofs, "a contact direction names a degree of freedom that does not exist");
      expect(std::isfinite(coefficient), "every coefficient of a contact direction must be finite");
    }
  validate_mass(mass, dofs);
  const auto moves = [&](const Term& t) {
    return t.coefficient != 0 && (!is_diagonal(mass, dofs) || std::isfinite(mass[t.dof]));
  };
  for (std::size_t j = 0; j < contact.size(); ++j)
    if (std::none_of(contact[j].begin(), contact[j].end(), moves))
      throw InvalidParameter("contact " + std::to_string(j + 1) + " joins nothing that can move");
}

std::vector<double> solve(const MassMatrix& mass, std::vector<double> y) {
  const Index n = std::ssize(y);
  if (is_diagonal(mass, n)) {
    for (Index i = 0; i < n; ++i) y[i] /= mass[i];
    return y;
  }
  const Vector solution = full(mass, n).llt().solve(Eigen::Map<const Vector>(y.data(), n));
  return {solution.begin(), solution.end()};
}

std::vector<ContactDirection> responses(const MassMatrix& mass, const std::vector<ContactDirection>& contact,
                                        Index dofs) {
  std::vector<ContactDirection> columns;
  responses(mass, contact, dofs, columns);
  return columns;
}

void responses(const MassMatrix& mass, const std::vector<ContactDirection>& contact, Index dofs,
               std::vector<ContactDirection>& columns) {
  if (is_diagonal(mass, dofs))
    return divide(
        contact, [&](Index i) { return mass[i]; }, columns);
  const Eigen::LLT<Matrix> factor(full(mass, dofs));
  solve_columns(
      contact, dofs, [&](Vector& column) { factor.solveInPlace(column); }, columns);
}

void half_responses(const MassMatrix& mass, const std::vector<ContactDirection>& contact, Index dofs,
                    std::vector<ContactDirection>& columns) {
  if (is_diagonal(mass, dofs))
    return divide(
        contact, [&](Index i) { return std::sqrt(mass[i]); }, columns);
  const Eigen::LLT<Matrix> factor(full(mass, dofs));
  solve_columns(
      contact, dofs, [&](Vector& column) { factor.matrixL().solveInPlace(column); }, columns);
}

}  // namespace mariotte::model
