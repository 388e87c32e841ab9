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

Eigen::Map<const Matrix> full(const MassMatrix& mass, Index freedoms) {
  return {mass.data(), freedoms, freedoms};
}

void expect(bool holds, const std::string& rule) {
  if (!holds) throw InvalidParameter(rule);
}

void validate_mass(const MassMatrix& mass, Index freedoms) {
  if (is_diagonal(mass, freedoms)) {
    for (const double m : mass) expect(m > 0, "every mass must be positive");
    return;
  }
  expect(std::ssize(mass) == freedoms * freedoms,
         "the mass matrix needs one value per degree of freedom, or all rows");
  expect(std::all_of(mass.begin(), mass.end(), [](double m) { return std::isfinite(m); }),
         "a full mass matrix must be finite");
  const auto m = full(mass, freedoms);
  expect((m - m.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * m.cwiseAbs().maxCoeff(),  // as written by hand
         "the mass matrix must be symmetric");
  expect(Eigen::LLT<Matrix>(m).info() == Eigen::Success, "the mass matrix must be positive definite");
}

/// The directions with each coefficient over its freedom's divisor.
template <class Divisor>
std::vector<ContactDirection> divided(const std::vector<ContactDirection>& contact, Divisor&& divisor) {
  std::vector<ContactDirection> quotient(contact.size());
  for (std::size_t j = 0; j < contact.size(); ++j)
    for (const auto& [freedom, coefficient] : contact[j])
      if (coefficient != 0 && std::isfinite(divisor(freedom)))
        quotient[j].push_back({freedom, coefficient / divisor(freedom)});
  return quotient;
}

/// The directions, each as a full column, after `solve` has changed it in place.
template <class Solve>
std::vector<ContactDirection> solved(const std::vector<ContactDirection>& contact, Index freedoms,
                                     Solve&& solve) {
  std::vector<ContactDirection> solution(contact.size());
  for (std::size_t j = 0; j < contact.size(); ++j) {
    Vector column = Vector::Zero(freedoms);
    for (const auto& [freedom, coefficient] : contact[j]) column[freedom] += coefficient;
    solve(column);
    for (Index i = 0; i < freedoms; ++i)
      if (column[i] != 0) solution[j].push_back({i, column[i]});
  }
  return solution;
}

}  // namespace

void validate(const MassMatrix& mass, const std::vector<ContactDirection>& contact, Index freedoms) {
  for (const auto& direction : contact)
    for (const auto& [freedom, coefficient] : direction) {
      expect(freedom >= 0 && freedom < freedoms, "a contact direction names a freedom that does not exist");
      expect(std::isfinite(coefficient), "every coefficient of a contact direction must be finite");
    }
  validate_mass(mass, freedoms);
  const auto moves = [&](const Term& t) {
    return t.coefficient != 0 && (!is_diagonal(mass, freedoms) || std::isfinite(mass[t.freedom]));
  };
  for (std::size_t j = 0; j < contact.size(); ++j)
    expect(std::any_of(contact[j].begin(), contact[j].end(), moves),
           "contact " + std::to_string(j + 1) + " joins nothing that can move");
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
                                        Index freedoms) {
  if (is_diagonal(mass, freedoms)) return divided(contact, [&](Index i) { return mass[i]; });
  const Eigen::LLT<Matrix> factor(full(mass, freedoms));
  return solved(contact, freedoms, [&](Vector& column) { factor.solveInPlace(column); });
}

std::vector<ContactDirection> half_responses(const MassMatrix& mass,
                                             const std::vector<ContactDirection>& contact, Index freedoms) {
  if (is_diagonal(mass, freedoms)) return divided(contact, [&](Index i) { return std::sqrt(mass[i]); });
  const Eigen::LLT<Matrix> factor(full(mass, freedoms));
  return solved(contact, freedoms, [&](Vector& column) { factor.matrixL().solveInPlace(column); });
}

}  // namespace mariotte::model
