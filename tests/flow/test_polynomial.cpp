#define BOOST_TEST_MODULE first roots of polynomials
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "mariotte/flow/roots/polynomial.hpp"

using namespace mariotte::flow;
using Numbers = std::vector<double>;

namespace {

Numbers times(const Numbers& a, const Numbers& b) {
  Numbers product(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  return product;
}

/// Π (1 − x/root), which is 1 at 0.
Numbers with_roots(const Numbers& roots) {
  Numbers c = {1};
  for (const double root : roots) c = times(c, {1, -1 / root});
  return c;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_first_of_several_roots_is_found) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.05, 1.5);
  for (int i = 0; i < 2000; ++i) {
    Numbers roots(1 + static_cast<std::size_t>(i) % 7);
    for (double& root : roots) root = place(random);
    const double first = *std::min_element(roots.begin(), roots.end());
    double nearest = 10;
    for (const double root : roots)
      if (root != first) nearest = std::min(nearest, root - first);
    const auto found = first_fall(with_roots(roots), 1);
    if (nearest < 1e-3) continue;  // nearly double: its place is ill-conditioned
    BOOST_TEST(found.has_value() == (first <= 1));
    if (found) BOOST_TEST(std::abs(*found - first) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(two_close_roots_are_not_skipped) {
  for (const double apart : {1e-2, 1e-4, 1e-6}) {
    const auto found = first_fall(times(with_roots({0.4, 0.4 + apart}), {1, 0.3, 0.2, 0.1, 0.05}), 1);
    BOOST_REQUIRE(found.has_value());
    BOOST_TEST(std::abs(*found - 0.4) < 0.1 * apart);
  }
}

BOOST_AUTO_TEST_CASE(a_dip_that_stays_positive_has_no_root) {
  for (const double depth : {1e-2, 1e-6, 1e-10}) {
    auto c = times(with_roots({0.6, 0.6}), {1, -0.2, 0.1, 0.1, 0.1, -0.05});
    c[0] += depth;
    BOOST_TEST(!first_fall(c, 1).has_value());
  }
}

BOOST_AUTO_TEST_CASE(what_is_said_to_fall_never_rises) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  int said = 0;
  for (int i = 0; i < 2000; ++i) {
    Numbers c = {0, -1};
    while (c.size() < 9) c.push_back(any(random));
    const double end = 0.7;
    if (!falls(c, end)) continue;
    ++said;
    for (double x = 0; x < end; x += 0.01) BOOST_TEST(horner(c, x + 0.01) < horner(c, x));
  }
  BOOST_TEST(said > 200);
  BOOST_TEST(!falls(Numbers{0, -1, 1}, 0.7));
  BOOST_TEST(falls(Numbers{0, -1, 1}, 0.4));
}

BOOST_AUTO_TEST_CASE(a_root_at_the_start_does_not_count) {
  const auto rises_and_falls = times({0, 1}, with_roots({0.7}));
  BOOST_TEST(std::abs(*first_fall(rises_and_falls, 1) - 0.7) < 1e-14);
  BOOST_TEST(!first_fall(rises_and_falls, 0.5).has_value());
  auto rounded = rises_and_falls;
  rounded[0] = -1e-17;
  BOOST_TEST(std::abs(*first_fall(rounded, 1) - 0.7) < 1e-14);
  BOOST_TEST(!first_fall(rounded, 0.5).has_value());
}

// Clocks: t = τ² stands still at its start, and x + x³ does not.
BOOST_AUTO_TEST_CASE(a_clock_is_read_backwards) {
  for (const std::vector<double>& clock :
       {std::vector{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0, 1.0}, {0.0, 1e-9, 0.0, 0.0, 1.0}})
    for (const double place : {1e-9, 1e-3, 0.3, 0.999, 1.0})
      BOOST_TEST(rise_to(clock, horner(clock, place), 1) == place, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rise_to(std::vector{0.0, 1.0}, 3, 2) == 2);
}
