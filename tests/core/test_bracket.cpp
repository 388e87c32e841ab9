#define BOOST_TEST_MODULE core_bracket
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>

#include "mariotte/core/bracket.hpp"

using mariotte::locate_sign_change;

namespace {

struct Search {
  double root;
  int evaluations;
};

template <class Function>
Search search(const Function& f, double low, double high, double tolerance) {
  int count = 0;
  const auto counted = [&](double x) { return ++count, f(x); };
  const double root = locate_sign_change(counted, low, f(low), high, f(high), tolerance);
  return {root, count};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_smooth_function_needs_few_evaluations) {
  const auto found = search([](double x) { return std::cos(x); }, 1.0, 2.0, 1e-12);
  BOOST_TEST(found.root == std::acos(0.0), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(found.evaluations <= 8);
}

BOOST_AUTO_TEST_CASE(a_root_far_from_the_middle_is_found) {
  for (const double root : {1e-9, 1e-3, 0.5, 1 - 1e-9}) {
    const auto found = search([&](double x) { return std::sqrt(root) - std::sqrt(x); }, 0, 1, 1e-14 * root);
    BOOST_TEST(found.root == root, boost::test_tools::tolerance(1e-10));
  }
}

BOOST_AUTO_TEST_CASE(a_function_that_is_flat_on_one_side_is_not_much_worse_than_halving) {
  const auto found = search([](double x) { return std::pow(x, 5) - std::pow(0.01, 5); }, 0, 1, 1e-14);
  BOOST_TEST(found.root == 0.01, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(found.evaluations <= 50);  // halving takes 47
}

BOOST_AUTO_TEST_CASE(slopes_lead_to_where_a_function_falls_whichever_end_it_is_told_first) {
  for (const double sign : {1.0, -1.0}) {
    int evaluations = 0;
    const auto f = [&](double x) {
      ++evaluations;
      return std::pair(std::cos(x), -std::sin(x));
    };
    const double root = mariotte::locate_fall(f, sign * 0.1, sign * 3.0, 1e-15);
    BOOST_TEST(root == sign * std::acos(0.0), boost::test_tools::tolerance(1e-15));
    BOOST_TEST(evaluations <= 10);
  }
}

BOOST_AUTO_TEST_CASE(slopes_that_lead_astray_do_not_lose_the_root) {
  // Newton's method alone runs away from x^{1/3}.
  const auto f = [](double x) {
    const double root = std::cbrt(0.3 - x);
    return std::pair(root, -1 / (3 * root * root));
  };
  BOOST_TEST(mariotte::locate_fall(f, 0.0, 1.0, 1e-12) == 0.3, boost::test_tools::tolerance(1e-11));
}
