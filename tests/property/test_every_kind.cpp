#define BOOST_TEST_MODULE chains of every kind
#include <boost/test/unit_test.hpp>

#include "support/random_chains.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

// Walls, gravity, rows at rest, many events at one instant, any accuracy: a run ends, at a limit if need be,
// and what it says is finite and balanced.
BOOST_AUTO_TEST_CASE(every_run_ends_with_closed_balances) {
  std::mt19937_64 random(1686);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 300; ++i)
    for (const auto kind : kinds) {
      const auto chain = random_chain(random, kind);
      hybrid::Options options{.accuracy = std::pow(10, -4 - 7 * uniform(random)), .max_events = 2000};
      if (kind == Kind::falling_on_a_wall || kind == Kind::between_walls)
        options.max_time = 1 + 20 * uniform(random);
      const auto impact = impact::simulate(chain, options);
      BOOST_TEST_CONTEXT("scene " << i << " of kind " << static_cast<int>(kind) << ": " << impact.message) {
        BOOST_TEST(
            (impact.ending == (std::isfinite(options.max_time) ? impact.ending : hybrid::Ending::separated)));
        BOOST_TEST((impact.ending != hybrid::Ending::failed));
        const double energy = impact.energy.initial + std::abs(impact.energy.work);
        BOOST_TEST(std::abs(impact.energy.residual) <= 100 * options.accuracy * energy);
        BOOST_TEST(std::isfinite(impact.time));
        for (const double v : impact.velocity) BOOST_TEST(std::isfinite(v));
        for (const auto& contact : impact.contacts) BOOST_TEST(contact.dissipated >= 0);
      }
    }
}

BOOST_AUTO_TEST_CASE(closed_forms_and_cvode_agree_where_everything_happens_at_once) {
  std::mt19937_64 random(1687);
  for (int i = 0; i < 200; ++i) {
    const auto chain = random_chain(random, Kind::equal_and_touching);
    const auto exact = impact::simulate(chain, {.accuracy = 1e-9});
    const auto cvode = impact::simulate(chain, {.accuracy = 1e-9, .flow = flow::Kind::cvode_adams});
    BOOST_TEST_CONTEXT("scene " << i) BOOST_TEST(difference(exact.velocity, cvode.velocity) < 1e-7);
  }
}
