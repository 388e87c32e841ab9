// Guards that are polynomials over a step. Terms are written for a step of length 1.
#define BOOST_TEST_MODULE flow series guards
#include <boost/test/unit_test.hpp>

#include "mariotte/flow/series_guards.hpp"

using namespace mariotte;
using flow::SeriesEnd;

namespace {

SeriesEnd end_of(const std::vector<double>& row, double rounding) {
  SeriesEnd end{1};
  flow::look(7, {row}, rounding, end);
  return end;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_guard_falls_where_its_polynomial_does) {
  const auto end = end_of({1, -3, 0, 0}, 0);
  BOOST_TEST(end.guard == 7);
  BOOST_TEST(end.place == 1.0 / 3, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_guard_that_begins_within_rounding_of_zero_begins_there) {
  const auto end = end_of({1e-12, -1e-11, 1, -2, 0, 0}, 1e-8);  // x² − 2 x³
  BOOST_TEST(end.guard == 7);
  BOOST_TEST(end.place == 0.5, boost::test_tools::tolerance(1e-14));
}

// 0.005 x² is less than rounding of what the guard does in the whole step. Where 0.02 x³ − 2·10⁴ x⁴ comes
// back to zero, at 10⁻⁶, it is what the guard is made of.
BOOST_AUTO_TEST_CASE(first_terms_that_keep_a_guard_above_zero_count) {
  const auto end = end_of({1e-16, 0, 0.005, 0.02, -2e4, 0, 0}, 5e-7);
  BOOST_TEST(end.guard == 7);
  BOOST_TEST(end.place == std::sqrt(0.005 / 2e4), boost::test_tools::tolerance(1e-2));
}
