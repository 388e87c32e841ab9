// A chain in islands does what the chain as one system does.
#define BOOST_TEST_MODULE islands
#include <boost/test/unit_test.hpp>

#include "support/island_scenes.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

constexpr double accuracy = 1e-9;

/// Long enough for waves to cross, meet and come back.
hybrid::Options options(const model::Chain& chain, hybrid::Islands islands) {
  return {.accuracy = accuracy, .max_time = 10 + static_cast<double>(chain.mass.size()), .islands = islands};
}

double largest_speed(const model::Chain& chain) {
  double speed = 0;
  for (const double v : chain.velocity) speed = std::max(speed, std::abs(v));
  return speed > 0 ? speed : 1;
}

double apart(const model::Chain& chain, const impact::ChainImpact& a, const impact::ChainImpact& b) {
  return difference(a.velocity, b.velocity) / largest_speed(chain);
}

/// How far the chain as one system is from its own answer at a hundredth of the accuracy: hundreds of
/// contacts in a row can blow up the error of any run.
double blow_up(const model::Chain& chain, const impact::ChainImpact& whole) {
  auto tighter = options(chain, hybrid::Islands::never);
  tighter.accuracy *= 1e-2;
  return apart(chain, whole, impact::simulate(chain, tighter));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_thousand_random_chains_in_islands_are_what_they_are_as_one_system) {
  IslandSceneMaker maker(2003);
  int blown_up = 0;
  for (int i = 0; i < 1000; ++i) {
    const int kind = i % island_scene_kinds;
    const auto chain = maker.make(static_cast<IslandScene>(kind));
    const auto whole = impact::simulate(chain, options(chain, hybrid::Islands::never));
    const auto islands = impact::simulate(chain, options(chain, hybrid::Islands::always));
    BOOST_TEST_CONTEXT("scene " << i << " of kind " << kind << ", " << chain.mass.size() << " balls") {
      BOOST_TEST((whole.ending == islands.ending));
      BOOST_TEST(period_counts(islands) == period_counts(whole), boost::test_tools::per_element());
      BOOST_TEST(std::abs(islands.energy.residual) <= 100 * accuracy * islands.energy.initial);
      BOOST_TEST(std::abs(whole.energy.residual) <= 100 * accuracy * whole.energy.initial);
      const double error = apart(chain, islands, whole);
      if (error <= 10 * accuracy) continue;
      ++blown_up;
      BOOST_TEST(error <= 30 * blow_up(chain, whole));
    }
  }
  BOOST_TEST_MESSAGE(blown_up << " scenes blow up errors");
  BOOST_TEST(blown_up <= 20);
}

BOOST_AUTO_TEST_CASE(two_waves_are_two_islands_and_cross_each_other) {
  auto chain = equal_chain(200);
  chain.velocity[199] = -1;
  const auto before = impact::simulate(chain, {.max_time = 100});
  BOOST_TEST(before.skipped.front().why.ends_with("up to 2 at one time"));
  const auto after = impact::simulate(chain, {.max_time = 150});
  for (std::size_t i = 0; i < 100; ++i)
    BOOST_TEST(std::abs(after.velocity[i] + after.velocity[199 - i]) < 1e-9);
  BOOST_TEST(std::abs(after.energy.residual) < 1e-9);
}

// Balls that fall together stay together until the wave from the wall reaches them.
BOOST_AUTO_TEST_CASE(a_column_in_flight_is_not_integrated) {
  auto chain = equal_chain(300);
  chain.mass[0] = infinity;
  chain.velocity.assign(300, -1.0);
  chain.velocity[0] = 0;
  chain.gap[0] = 2;
  chain.gravity = 0.01;
  const auto impact = impact::simulate(chain, {.max_time = 50});
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-8 * impact.energy.initial);
  const double fallen = -1 - chain.gravity * impact.time;
  for (std::size_t i = 200; i < 300; ++i) BOOST_TEST(std::abs(impact.velocity[i] - fallen) < 1e-12);
  BOOST_TEST(impact.contacts[0].periods.size() == 1u);
  BOOST_TEST(impact.contacts[0].periods[0].start > 1.9);
}

// Behind the wave balls approach each other more slowly than can be told from rest, for a long time.
BOOST_AUTO_TEST_CASE(balls_that_hover_get_no_deeper_than_an_approach_that_counts_as_none) {
  auto chain = equal_chain(300);
  for (std::size_t i = 0; i < 300; i += 7) chain.mass[i] = 1 + 1e-9;
  for (const double accuracy : {1e-9, 1e-10}) {
    const auto impact = impact::simulate(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated));
    for (const double gap : impact.gap) BOOST_TEST(gap > -accuracy);
  }
}
