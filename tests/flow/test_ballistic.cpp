#define BOOST_TEST_MODULE ballistic flow
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/flow/ballistic.hpp"

using namespace mariotte;
using flow::Crossing;
using flow::first_crossing;

namespace {
const auto tight = boost::test_tools::tolerance(4e-16);
}

BOOST_AUTO_TEST_CASE(straight_line_meets_zero_where_it_should) {
  BOOST_TEST(first_crossing(Crossing::falling, 3, -2, 0) == 1.5);
  BOOST_TEST(first_crossing(Crossing::rising, -3, 2, 0) == 1.5);
  BOOST_TEST(first_crossing(Crossing::falling, 3, 2, 0) == infinity);
  BOOST_TEST(first_crossing(Crossing::rising, 3, 2, 0) == infinity);
}

BOOST_AUTO_TEST_CASE(a_masked_guard_never_fires) {
  BOOST_TEST(first_crossing(Crossing::none, 3, -2, 0) == infinity);
}

BOOST_AUTO_TEST_CASE(a_value_of_zero_at_the_start_does_not_fire) {
  BOOST_TEST(first_crossing(Crossing::falling, 0, -1, 0) == infinity);
  BOOST_TEST(first_crossing(Crossing::falling, 0, 0, 0) == infinity);
  BOOST_TEST(first_crossing(Crossing::rising, 0, 1, 0) == infinity);
}

BOOST_AUTO_TEST_CASE(thrown_up_it_comes_down) {
  // t − t²/2 falls through zero at t = 2, having risen through it at 0
  BOOST_TEST(first_crossing(Crossing::falling, 0, 1, -1) == 2, tight);
  BOOST_TEST(first_crossing(Crossing::falling, 1, 1, -1) == 1 + std::sqrt(3.0), tight);
}

BOOST_AUTO_TEST_CASE(a_parabola_that_turns_before_zero_never_fires) {
  BOOST_TEST(first_crossing(Crossing::falling, 1, -1, 1) == infinity);
}

BOOST_AUTO_TEST_CASE(each_direction_finds_its_own_root) {
  // (t − 1)(t − 3)/… with value 3, rate −4, bend 2: falls at 1, rises at 3
  BOOST_TEST(first_crossing(Crossing::falling, 3, -4, 2) == 1, tight);
  BOOST_TEST(first_crossing(Crossing::rising, 3, -4, 2) == 3, tight);
}

BOOST_AUTO_TEST_CASE(nearly_equal_terms_do_not_cancel) {
  // Roots at about 1e-12 and 2: a formula that subtracts loses all digits of the small one.
  const double root = first_crossing(Crossing::falling, 1e-12, -1, 1);
  BOOST_TEST(root == 1e-12 * (1 + 0.5e-12), tight);
}

BOOST_AUTO_TEST_CASE(extreme_sizes_do_not_overflow) {
  BOOST_TEST(first_crossing(Crossing::falling, 1e300, -1e300, -1e-300) == 1, tight);
  BOOST_TEST(first_crossing(Crossing::falling, 1e-300, 0, -1e-300) == std::sqrt(2.0), tight);
  BOOST_TEST(first_crossing(Crossing::falling, 1e200, 0, -1e200) == std::sqrt(2.0), tight);
}
