#define BOOST_TEST_MODULE study_least_squares
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/study/fit/least_squares.hpp"

using namespace mariotte;
using study::LeastSquares;
using study::minimise;

namespace {

/// (10 (y − x²), 1 − x): a curved valley with its only minimum, zero, at (1, 1) [Rosenbrock 1960].
const LeastSquares valley{.count = 2,
                          .residuals =
                              [](auto x, auto r) {
                                r[0] = 10 * (x[1] - x[0] * x[0]);
                                r[1] = 1 - x[0];
                              },
                          .slopes =
                              [](auto x, auto columns) {
                                columns[0] = -20 * x[0];
                                columns[1] = -1;
                                columns[2] = 10;
                                columns[3] = 0;
                              }};

}  // namespace

BOOST_AUTO_TEST_CASE(a_curved_valley_is_followed_to_its_end) {
  const auto found = minimise(valley, {-1.2, 1});
  BOOST_TEST(found.converged);
  BOOST_TEST(std::abs(found.x[0] - 1) < 1e-9);
  BOOST_TEST(std::abs(found.x[1] - 1) < 1e-9);
}

// The mean is what leaves the least sum of squares.
BOOST_AUTO_TEST_CASE(residuals_that_do_not_vanish_are_balanced) {
  const LeastSquares mean{
      .count = 3,
      .residuals =
          [](auto x, auto r) {
            r[0] = x[0] - 1;
            r[1] = x[0] - 2;
            r[2] = x[0] - 6;
          },
      .slopes = [](auto, auto columns) { std::fill(columns.begin(), columns.end(), 1.0); }};
  const auto found = minimise(mean, {1});
  BOOST_TEST(found.converged);
  BOOST_TEST(std::abs(found.x[0] - 3) < 1e-12);
}

BOOST_AUTO_TEST_CASE(the_search_turns_back_where_the_residuals_make_no_sense) {
  int refused = 0;
  const LeastSquares root{.count = 1,
                          .residuals =
                              [&](auto x, auto r) {
                                if (x[0] < 0.5 && ++refused > 0) throw Error("too small");
                                r[0] = std::sqrt(x[0]) - 0.8;
                              },
                          .slopes = [](auto x, auto columns) { columns[0] = 0.5 / std::sqrt(x[0]); }};
  const auto found = minimise(root, {3});
  BOOST_TEST(refused > 0);
  BOOST_TEST(found.converged);
  BOOST_TEST(std::abs(found.x[0] - 0.64) < 1e-10);
  BOOST_CHECK_THROW(minimise(root, {0.1}), Error);
}

BOOST_AUTO_TEST_CASE(slopes_that_are_not_finite_end_the_search) {
  const LeastSquares root{.count = 1,
                          .residuals = [](auto x, auto r) { r[0] = std::sqrt(x[0]) - 0.01; },
                          .slopes = [](auto x, auto columns) { columns[0] = 0.5 / std::sqrt(x[0]); }};
  const auto found = minimise(root, {1});  // its first step leads to 0
  BOOST_TEST(!found.converged);
  BOOST_TEST(found.message.find("not finite") != std::string::npos, found.message);
}

BOOST_AUTO_TEST_CASE(a_search_without_end_is_not_taken_for_a_minimum) {
  const LeastSquares endless{
      .count = 1,
      .residuals = [](auto x, auto r) { r[0] = std::pow(x[0], -0.1); },
      .slopes = [](auto x, auto columns) { columns[0] = -0.1 * std::pow(x[0], -1.1); }};
  const auto found = minimise(endless, {1});
  BOOST_TEST(!found.converged);
  BOOST_TEST(found.message.find("did not converge within 400 evaluations") != std::string::npos,
             found.message);
}
