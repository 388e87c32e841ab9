#define BOOST_TEST_MODULE relative energies
#include <Eigen/SVD>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "mariotte/impact/laws/configuration.hpp"

using namespace mariotte;
using namespace mariotte::impact;

namespace {

using Numbers = std::vector<double>;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Up to 25 disks whose masses span some decades, with up to three random contacts each, some of them twice.
Configuration random_disks(std::mt19937_64& random, double decades) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<Index> size(2, 25);
  const Index disks = size(random), contacts = std::uniform_int_distribution<Index>(1, 3 * disks)(random);
  std::uniform_int_distribution<Index> any(0, disks - 1), other(1, disks - 1);
  Configuration c;
  for (Index i = 0; i < disks; ++i) {
    c.mass.insert(c.mass.end(), 2, std::pow(10, decades * (unit(random) - 0.5)));
    for (int k = 0; k < 2; ++k) c.velocity.push_back(2 * unit(random) - 1);
  }
  for (Index j = 0; j < contacts; ++j) {
    const Index a = any(random), b = (a + other(random)) % disks;
    const double angle = 2 * std::numbers::pi * unit(random), x = std::cos(angle), y = std::sin(angle);
    c.contact.insert(c.contact.end(), 1 + j % 2, {{2 * a, -x}, {2 * a + 1, -y}, {2 * b, x}, {2 * b + 1, y}});
  }
  return c;
}

/// Of a diagonal mass matrix, by dense singular values of L⁻¹ Gᵀ with columns of length 1.
double by_singular_values(const Configuration& c) {
  Matrix scaled = Matrix::Zero(std::ssize(c.velocity), std::ssize(c.contact));
  Vector rates(scaled.cols());
  for (Index j = 0; j < scaled.cols(); ++j) {
    for (const auto& [dof, coefficient] : c.contact[j]) scaled(dof, j) = coefficient / std::sqrt(c.mass[dof]);
    rates[j] = gap_rate(c.contact[j], c.velocity) / scaled.col(j).norm();
    scaled.col(j).normalize();
  }
  Eigen::JacobiSVD<Matrix> svd(scaled.transpose(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(1e-12);
  return 0.5 * svd.solve(rates).squaredNorm();
}

void compare(double decades, double tolerance) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 200; ++i) {
    const auto c = random_disks(random, decades);
    BOOST_TEST(relative_energy(c, c.velocity) == by_singular_values(c),
               boost::test_tools::tolerance(tolerance));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(energies_of_disks_with_redundant_contacts_are_those_of_singular_values) {
  compare(0, 1e-11);
  compare(4, 1e-11);
}

BOOST_AUTO_TEST_CASE(energies_are_right_where_disks_hardly_feel_others) {
  compare(12, 1e-9);  // as far as doubles hold what disks 10¹² times as heavy leave of the light ones' motion
}

BOOST_AUTO_TEST_CASE(disks_between_moving_walls_count_with_the_nearest_rates_they_could_have) {
  std::mt19937_64 random(12);
  for (int i = 0; i < 200; ++i) {
    auto c = random_disks(random, 1);
    for (Index dof = 0; dof < std::min<Index>(6, std::ssize(c.mass) - 2); ++dof) c.mass[dof] = infinity;
    std::erase_if(c.contact, [&](const auto& direction) {
      return std::all_of(direction.begin(), direction.end(),
                         [&](const Term& term) { return std::isinf(c.mass[term.dof]); });
    });
    if (c.contact.empty()) continue;
    BOOST_TEST(relative_energy(c, c.velocity) == by_singular_values(c), boost::test_tools::tolerance(1e-10));
  }
}

BOOST_AUTO_TEST_CASE(rest_has_no_energy) {
  const auto c = chain_configuration({1, 1, 1}, {3, 3, 3});
  BOOST_TEST(relative_energy(c, c.velocity) == 0);
}

BOOST_AUTO_TEST_CASE(walls_that_squeeze_a_ball_count_with_the_nearest_rates_it_could_have) {
  const auto c = chain_configuration({infinity, 2, infinity}, {1, 0, -3});
  BOOST_TEST(relative_energy(c, c.velocity) == 0.5 * 2 * 1 * 1, boost::test_tools::tolerance(1e-12));
}
