// Impulses of light balls among heavy ones, whose momentum has no digits for them.
#define BOOST_TEST_MODULE light balls
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "support/reference.hpp"

using namespace mariotte;

namespace {

model::Chain row(std::vector<double> mass, double gap) {
  auto chain = test::equal_masses(std::vector<contact::Law>(mass.size() - 1, contact::Hertz{1}),
                                  std::vector<double>(mass.size(), 0.0));
  chain.mass = std::move(mass);
  chain.gap.assign(chain.mass.size() - 1, gap);
  chain.velocity[0] = 1;
  return chain;
}

double relative(double value, double exact) {
  return std::abs(value / exact - 1);
}

}  // namespace

// A ball so light that it leaves another one less than counts as rest: what that presses on the next is
// noise.
BOOST_AUTO_TEST_CASE(ratios_with_what_cannot_be_told_from_rest_are_undefined) {
  const auto chain = row({1e-7, 1, 1}, 0);
  impact::ChainSolver solver;
  for (const double accuracy : {1e-4, 1e-5}) {
    const auto impact = impact::simulate(chain, {.accuracy = accuracy});
    BOOST_TEST(!impact.icr[0].has_value());
    BOOST_TEST(impact.contacts[0].impulse == 2e-7, boost::test_tools::tolerance(1e-5));
    BOOST_TEST(solver.solve(chain, {.accuracy = accuracy}).impulse[1] == 0);
  }
  const auto exact = impact::simulate(chain, {.accuracy = 1e-12});
  BOOST_TEST(*exact.icr[0] == 1, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(solver.solve(chain, {.accuracy = 1e-12}).impulse[1] == 2e-7, boost::test_tools::tolerance(1e-5));
}

// Impulses integrated in extended precision, of a ball between two that it hardly moves.
BOOST_AUTO_TEST_CASE(a_ball_between_two_heavy_ones) {
  for (const double right : {1e10, infinity})
    for (const double left : {1e10, 1e14, 1e18}) {
      const auto chain = row({left, 1, right}, 0.063);
      const auto impact = impact::simulate(chain, {.accuracy = 1e-11, .max_time = 1.5});
      impact::ChainSolver solver;
      const auto brief = solver.solve(chain, {.accuracy = 1e-11, .max_time = 1.5}).impulse;
      for (const auto& p : {std::vector{impact.contacts[0].impulse, impact.contacts[1].impulse}, brief}) {
        BOOST_TEST(relative(p[0], 0.80558291689) < 3e-10);
        BOOST_TEST(relative(p[1], 0.029233493981) < 3e-10);
      }
      BOOST_TEST(relative(*impact.icr[0], 0.80558291689 / 0.029233493981) < 1e-9);
    }
}

// What a light ball has got is what it has.
BOOST_AUTO_TEST_CASE(a_grain_between_a_hammer_and_a_wall) {
  const auto impact =
      impact::simulate(row({1, 1e-10, infinity}, 0.1), {.accuracy = 1e-11, .max_time = 0.1001});
  BOOST_REQUIRE(impact.contacts[1].periods.empty());
  BOOST_TEST(relative(impact.contacts[0].impulse, 1e-10 * impact.velocity[1]) < 1e-10);
}

// Balls that get lighter towards the middle: each tells the difference of its two impulses, but for rounding.
BOOST_AUTO_TEST_CASE(series_and_steps_tell_the_same_impulses_of_a_row_with_a_waist) {
  const auto chain = row({1e8, 1e4, 1, 1e4, 1e8}, 0.01);
  const auto by = [&](flow::Kind kind) {
    return impact::simulate(chain, {.accuracy = 1e-12, .max_time = 60, .flow = kind});
  };
  const auto series = by(flow::Kind::taylor), steps = by(flow::Kind::cvode_adams);
  for (std::size_t j = 0; j < 4; ++j)
    BOOST_TEST(relative(steps.contacts[j].impulse, series.contacts[j].impulse) < 1e-10, j);
  const double gained = series.contacts[1].impulse - series.contacts[2].impulse;
  BOOST_TEST(std::abs(series.velocity[2] - gained) < 1e-10);
}
