#define BOOST_TEST_MODULE stiff damping
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/impact/chain_solver.hpp"
#include "support/reference.hpp"

using namespace mariotte;

namespace {

/// Balls and Hertz-like dampers over decades; many contacts creep, pressed by their neighbours.
model::Chain random_chain(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto decades = [&](double low, double high) {
    return std::pow(10, low + (high - low) * unit(random));
  };
  model::Chain chain;
  const int balls = std::uniform_int_distribution(2, 4)(random);
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(decades(-1, 1));
    chain.velocity.push_back(i == 0 ? 1 : -unit(random) * (unit(random) < 0.5));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(unit(random) < 0.7 ? 0 : 0.01 * unit(random));
    chain.law.push_back(
        contact::Viscoelastic{.stiffness = decades(-1, 1), .damping = decades(1, 4), .exponent = 1.5});
  }
  return chain;
}

}  // namespace

// The load of a creeping contact is a small difference of large terms: told with too few digits its sign
// makes ghost periods, and explicit steps would last for ever.
BOOST_AUTO_TEST_CASE(creeping_contacts_make_no_ghost_events_and_come_to_an_end) {
  std::mt19937_64 random(7);
  impact::ChainSolver solver;
  Index most_steps = 0;
  for (int i = 0; i < 80; ++i) {
    const auto chain = random_chain(random);
    const auto own = solver.solve(chain, {.accuracy = 1e-8});
    const auto exact = solver.solve(chain, {.accuracy = 1e-11, .flow = "cvode-bdf-klu"});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST((own.ending == hybrid::Ending::separated));
      BOOST_TEST(test::difference(own.velocity, exact.velocity) < 1e-8);
      BOOST_TEST(own.periods == exact.periods, boost::test_tools::per_element());
    }
    most_steps = std::max(most_steps, own.steps);
  }
  BOOST_TEST(most_steps < 50'000);
}
