// Collocation's equations are solved as a division of all of them at once would.
#define BOOST_TEST_MODULE impact_stage_system
#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/impact/sensitivity/gauss.hpp"
#include "mariotte/impact/sensitivity/stage_system.hpp"

using namespace mariotte;
using impact::stages;

namespace {

/// Three balls in a row: v1, v2, v3, g1, g2, the damped contact 1 and contact 2. Component 5 drives nothing.
const std::vector<flow::Entry> row = {{0, 3}, {1, 3}, {0, 0}, {0, 1}, {1, 0}, {1, 1}, {1, 4},
                                      {2, 4}, {3, 0}, {3, 1}, {4, 1}, {4, 2}, {5, 0}};
const std::vector<Index> position = {0, 1, 2, 3, 4, -1};
constexpr Index components = 5;
using Sizes = std::vector<double>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
const Sizes equal(components, 1.0);

struct Piece {
  std::vector<double> jacobian[stages];
  double h[stages];
  Rows right = Rows::Zero(components * stages, 2);
};

/// Entries that `is_open` are zero at all points.
template <class IsOpen>
Piece any_piece(IsOpen&& is_open) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-2, 2);
  Piece piece;
  for (int i = 0; i < stages; ++i) {
    piece.h[i] = any(random);
    for (const auto& entry : row) piece.jacobian[i].push_back(is_open(entry) ? 0 : any(random));
  }
  for (Index i = 0; i < piece.right.size(); ++i) piece.right(i) = any(random);
  return piece;
}

/// The same piece where components have other units.
Piece in_units(Piece piece, const Sizes& size) {
  for (int i = 0; i < stages; ++i)
    for (std::size_t e = 0; e < row.size(); ++e)
      if (const Index r = position[row[e].row]; r >= 0)
        piece.jacobian[i][e] *= size[r] / size[position[row[e].column]];
  for (Index r = 0; r < components * stages; ++r) piece.right.row(r) *= size[r % components];
  return piece;
}

/// Of the equations as they are written, where values are of order one.
double residual(const Piece& piece, const Rows& values) {
  Rows rest = values - piece.right;
  for (int i = 0; i < stages; ++i)
    for (int j = 0; j < stages; ++j)
      for (std::size_t e = 0; e < row.size(); ++e)
        if (const Index r = position[row[e].row]; r >= 0)
          rest.row(i * components + r) -= impact::gauss.integral[i][j] * piece.h[j] * piece.jacobian[j][e] *
                                          values.row(j * components + position[row[e].column]);
  return rest.cwiseAbs().maxCoeff() / values.cwiseAbs().maxCoeff();
}

void expect_solution(const Piece& piece, const Sizes& size = equal) {
  impact::StageSystem system(row, position, size);
  const auto given = in_units(piece, size);
  auto values = given.right;
  system.solve(given.jacobian, given.h, {values.data(), static_cast<std::size_t>(values.size())});
  for (Index r = 0; r < components * stages; ++r) values.row(r) /= size[r % components];
  BOOST_TEST(residual(piece, values) < 1e-13);
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_eliminated_and_what_is_kept_solve_all_equations) {
  BOOST_TEST(impact::StageSystem(row, position, equal).unknowns() < components * stages);
  expect_solution(any_piece([](const auto&) { return false; }));
}

BOOST_AUTO_TEST_CASE(what_nothing_acts_on_keeps_its_value) {
  expect_solution(any_piece([](const auto& entry) { return entry.row == 2 || entry.column == 4; }));
  expect_solution(any_piece([](const auto& entry) { return entry.row < 3; }));
}

BOOST_AUTO_TEST_CASE(units_cost_no_digits) {
  expect_solution(any_piece([](const auto&) { return false; }), {1, 1e7, 1e-7, 1e-3, 1e5});
}
