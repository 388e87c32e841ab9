#define BOOST_TEST_MODULE core_bracket
#include <boost/test/unit_test.hpp>
#include <cmath>

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
