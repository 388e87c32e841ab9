#define BOOST_TEST_MODULE linear triplet
#include <boost/test/unit_test.hpp>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/laws/linear_triplet.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using impact::FirstToOpen;
using impact::LinearTripletImpact;

namespace {

constexpr double rounding = 1e-14;

LinearTripletImpact of_ratio(double ratio) {
  return impact::linear_triplet({.ratio = ratio});
}

template <std::size_t n>
double difference(const std::array<double, n>& a, const std::vector<double>& b) {
  return test::difference({a.begin(), a.end()}, b);
}

model::Chain chain(const impact::LinearTriplet& t) {
  return {.mass = {t.mass, t.mass, t.mass},
          .law = {contact::Linear{t.stiffness}, contact::Linear{t.stiffness * t.ratio}},
          .gap = {0, 0},
          .velocity = {t.speed, 0, 0}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(closed_form_agrees_with_extended_precision) {
  for (const auto& c : test::cases("linear_triplets.json")) {
    BOOST_TEST_CONTEXT("ratio " << c.at("kappa")) {
      const auto closed = of_ratio(c.at("kappa"));
      BOOST_TEST(difference(closed.velocity, c.at("final")) < rounding);
      BOOST_TEST(difference(closed.impulse, c.at("impulse")) < rounding);
      const double end = std::max(closed.opening[0], closed.opening[1]);
      BOOST_TEST(end == c.at("time").get<double>(), boost::test_tools::tolerance(rounding));
    }
  }
}

BOOST_AUTO_TEST_CASE(closed_form_agrees_with_natural_modes_over_fourteen_decades) {
  impact::ChainSolver solver;
  constexpr int values = 1400;
  double worst = 0;
  for (int i = 0; i <= values; ++i) {
    const impact::LinearTriplet triplet{.ratio = std::pow(10, -4 + 14.0 * i / values)};
    const auto closed = impact::linear_triplet(triplet);
    const auto& run = solver.solve(chain(triplet), {.accuracy = 1e-14, .flow = flow::Kind::modal});
    worst =
        std::max({worst, difference(closed.velocity, run.velocity), difference(closed.impulse, run.impulse)});
  }
  BOOST_TEST(worst < 1e-13);
}

BOOST_AUTO_TEST_CASE(contacts_open_when_the_simulation_says_so) {
  for (const double ratio : {1e-3, 0.3, 1.0, 2.0, 3.0, 5.0, 9.0, 12.0, 40.0, 1e3, 1e6}) {
    BOOST_TEST_CONTEXT("ratio " << ratio) {
      const impact::LinearTriplet triplet{.ratio = ratio};
      const auto closed = impact::linear_triplet(triplet);
      const auto run = impact::simulate(chain(triplet), {.accuracy = 1e-14});
      for (std::size_t j = 0; j < 2; ++j) {
        BOOST_TEST_REQUIRE(run.contacts[j].periods.size() == 1);
        BOOST_TEST(*run.contacts[j].periods[0].end == closed.opening[j], boost::test_tools::tolerance(1e-11));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(order_of_opening_alternates_with_the_integer_part_of_the_frequency_ratio) {
  for (double ratio = 0.01; ratio < 1e4; ratio *= 1.0173) {
    const auto closed = of_ratio(ratio);
    const bool odd = static_cast<int>(impact::frequency_ratio(ratio)) % 2 == 1;
    const auto expected = ratio < 1 || odd ? FirstToOpen::contact_1 : FirstToOpen::contact_2;
    BOOST_TEST((closed.first == expected));
    BOOST_TEST((closed.opening[0] < closed.opening[1]) == (expected == FirstToOpen::contact_1));
  }
}

BOOST_AUTO_TEST_CASE(at_integer_frequency_ratios_both_contacts_open_at_once) {
  for (int j = 2; j <= 40; ++j) {
    BOOST_TEST_CONTEXT("j = " << j) {
      const double ratio = impact::integer_stiffness_ratio(j);
      BOOST_TEST(impact::frequency_ratio(ratio) == j, boost::test_tools::tolerance(rounding));
      const auto closed = of_ratio(ratio);
      BOOST_TEST((closed.first == FirstToOpen::both));
      BOOST_TEST(closed.opening[0] == closed.opening[1], boost::test_tools::tolerance(rounding));
      const auto exact = impact::integer_velocities(j);
      BOOST_TEST(difference(closed.velocity, {exact.begin(), exact.end()}) < rounding);
      if (j % 2 == 1) BOOST_TEST(closed.icr == 2, boost::test_tools::tolerance(rounding));
      if (j % 2 == 0)
        BOOST_TEST(exact[2] == 2.0 * j * j / (3 * (j * j - 1)), boost::test_tools::tolerance(rounding));
    }
  }
}

// The constants stand in the theory page, to the digits of an evaluation in quadruple precision.
BOOST_AUTO_TEST_CASE(constants_of_the_first_integers_are_the_known_ones) {
  const auto close = boost::test_tools::tolerance(rounding);
  BOOST_TEST(impact::integer_stiffness_ratio(3) == 6.1712927295533244, close);
  BOOST_TEST(impact::integer_stiffness_ratio(2) == 2.2413379135215670, close);
  BOOST_TEST(of_ratio(impact::integer_stiffness_ratio(2)).icr == 1.42153516540862679, close);
}

BOOST_AUTO_TEST_CASE(correlation_ratio_lies_between_one_and_two_and_is_not_monotone) {
  int rises = 0, falls = 0;
  double before = 1;
  for (double ratio = 1e-6; ratio < 1e12; ratio *= 1.037) {
    const double icr = of_ratio(ratio).icr;
    BOOST_TEST(icr >= 1 - rounding);
    BOOST_TEST(icr <= 2 + rounding);
    rises += icr > before;
    falls += icr < before;
    before = icr;
  }
  BOOST_TEST(rises > 0);
  BOOST_TEST(falls > 0);
}

BOOST_AUTO_TEST_CASE(outcomes_scale_with_mass_stiffness_and_speed) {
  const auto unit = of_ratio(7);
  const auto scaled = impact::linear_triplet({.mass = 4, .stiffness = 1e10, .ratio = 7, .speed = 0.5});
  const auto close = boost::test_tools::tolerance(rounding);
  BOOST_TEST(scaled.icr == unit.icr, close);
  for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(scaled.velocity[i] == 0.5 * unit.velocity[i], close);
  for (std::size_t j = 0; j < 2; ++j) {
    BOOST_TEST(scaled.impulse[j] == 2 * unit.impulse[j], close);
    BOOST_TEST(scaled.opening[j] == 2e-5 * unit.opening[j], close);
  }
}

BOOST_AUTO_TEST_CASE(parameters_without_sense_are_refused) {
  for (const double bad : {0.0, -1.0, infinity, std::nan("")}) {
    BOOST_CHECK_THROW(of_ratio(bad), InvalidParameter);
    BOOST_CHECK_THROW(impact::linear_triplet({.mass = bad}), InvalidParameter);
  }
  BOOST_CHECK_THROW(impact::integer_stiffness_ratio(1), InvalidParameter);
}
