#define BOOST_TEST_MODULE long chains to their ends
#include <boost/test/unit_test.hpp>
#include <numeric>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "support/long_chains.hpp"

using namespace mariotte;
using namespace mariotte::test;

// Balls of different masses meet about n² times until they are sorted by velocity.
BOOST_AUTO_TEST_CASE(a_random_chain_of_ten_thousand_comes_to_its_end) {
  const auto chain = random_long_chain(10000);
  impact::ChainSolver solver;
  const auto& impact = solver.solve(chain, {.accuracy = 1e-10, .max_events = 1'000'000'000});
  BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);

  double momentum = 0, energy = 0;
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    momentum += chain.mass[i] * (impact.velocity[i] - chain.velocity[i]);
    energy += chain.mass[i] * (std::pow(impact.velocity[i], 2) - std::pow(chain.velocity[i], 2));
  }
  const double start = chain.mass[0] * chain.velocity[0];
  BOOST_TEST(std::abs(momentum) < 1e-10 * start);
  BOOST_TEST(std::abs(energy) < 1e-6 * start * chain.velocity[0]);
  for (std::size_t i = 0; i + 1 < impact.velocity.size(); ++i)
    BOOST_TEST(impact.velocity[i + 1] - impact.velocity[i] > -1e-8);

  const auto periods = std::accumulate(impact.periods.begin(), impact.periods.end(), Index{0});
  BOOST_TEST(impact.events <= 2 * periods);  // each closes and opens a contact that carried force
  for (std::size_t j = 0; j < impact.impulse.size(); ++j)
    BOOST_TEST((impact.impulse[j] > 0) == (impact.periods[j] > 0));
  BOOST_TEST_MESSAGE(impact.events << " events, " << periods << " contact periods, " << impact.steps
                                   << " steps, energy off by " << energy / start / chain.velocity[0]);
}
