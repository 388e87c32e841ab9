#define BOOST_TEST_MODULE scales
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/impact/laws/sequential_law.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/flow_steps.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

model::Chain triplet_of_stiffness(const std::string& law, double stiffness, double ratio) {
  return equal_masses({undamped(law, stiffness), undamped(law, ratio * stiffness)}, {1, 0, -0.25});
}

const char* const laws[] = {"linear", "hertz"};

}  // namespace

BOOST_AUTO_TEST_CASE(stiffness_from_1_to_1e30_changes_neither_steps_nor_velocities) {
  for (const auto* law : laws) {
    const auto soft = impact::simulate(triplet_of_stiffness(law, 1, 1));
    for (int decade = 3; decade <= 30; decade += 3) {
      const auto stiff = impact::simulate(triplet_of_stiffness(law, std::pow(10.0, decade), 1));
      BOOST_TEST(steps(stiff) == steps(soft));
      BOOST_TEST(stiff.velocity == soft.velocity, boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(powers_of_two_of_stiffness_scale_to_the_last_bit) {
  for (const auto* law : laws) {
    const auto soft = impact::simulate(triplet_of_stiffness(law, 1, 2.7));
    for (const int power : {1, 5, -7, 40, 99}) {
      const auto stiff = impact::simulate(triplet_of_stiffness(law, std::ldexp(1.0, power), 2.7));
      BOOST_TEST(steps(stiff) == steps(soft));
      BOOST_TEST(stiff.velocity == soft.velocity, boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(gaps_that_scale_with_the_indentation_keep_every_bit_too) {
  // Hertz: k → 2⁵ k divides lengths by 4; linear: k → 2² k halves them.
  const auto run = [](const std::string& law, double stiffness, double gap) {
    auto chain = triplet_of_stiffness(law, stiffness, 2.7);
    chain.gap = {0, gap};
    return impact::simulate(chain).velocity;
  };
  BOOST_TEST(run("hertz", 32, 0.03 / 4) == run("hertz", 1, 0.03), boost::test_tools::per_element());
  BOOST_TEST(run("linear", 4, 0.03 / 2) == run("linear", 1, 0.03), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(other_stiffnesses_agree_to_1e_minus_12) {
  for (const auto* law : laws) {
    const auto soft = impact::simulate(triplet_of_stiffness(law, 1, 2.7));
    for (const double stiffness : {3.3, 1e9, 7.7e29})
      BOOST_TEST(difference(impact::simulate(triplet_of_stiffness(law, stiffness, 2.7)).velocity,
                            soft.velocity) < 1e-12);
  }
}

// [Acary 2003, Prop. 2.1]: instants in natural time and ratios depend neither on k nor on m nor on v.
BOOST_AUTO_TEST_CASE(ratios_and_natural_instants_are_free_of_scale) {
  const auto unit = impact::simulate(equal_chain(3));
  auto chain = equal_chain(3);
  const double mass = 0.037, stiffness = 4.1e9, speed = 2.9;
  chain.mass.assign(3, mass);
  chain.law.assign(2, contact::Hertz{stiffness});
  chain.velocity[0] = speed;
  const auto impact = impact::simulate(chain);
  const double time = std::pow(mass * speed * speed / stiffness, 0.4) / speed;
  BOOST_TEST(*impact.icr[0] == *unit.icr[0], boost::test_tools::tolerance(1e-10));
  BOOST_TEST(impact.time / time == unit.time, boost::test_tools::tolerance(1e-9));
}

// The one group of damped contacts is Π = c v^{(n−1)/(n+1)} k^{−n/(n+1)} m^{−1/(n+1)}.
BOOST_AUTO_TEST_CASE(damped_ratios_depend_on_one_group_only) {
  const auto ratio = [](double stiffness, double damping, double mass, double speed) {
    const contact::Viscoelastic law{.stiffness = stiffness, .damping = damping, .exponent = 1.5};
    auto chain = equal_masses({law, law}, {speed, 0, 0});
    chain.mass.assign(3, mass);
    return *impact::simulate(chain).icr[0];
  };
  const double expected = 1.235423563129157, close = 1e-9;
  BOOST_TEST(std::abs(ratio(1, 0.2, 1, 1) - expected) < close);
  BOOST_TEST(std::abs(ratio(1e6, 0.2 * std::pow(1e6, 0.6), 1, 1) - expected) < close);
  BOOST_TEST(std::abs(ratio(1, 0.2 * std::pow(10, -0.2), 1, 10) - expected) < close);
  BOOST_TEST(std::abs(ratio(1, 0.2 * std::pow(7, 0.4), 7, 1) - expected) < close);
  // Not along c fixed (elastic limit) or c ~ k (plastic limit).
  BOOST_TEST(std::abs(ratio(1e6, 0.2, 1, 1) - 1.076864028916665) < close);
  BOOST_TEST(std::abs(ratio(1e6, 0.2e6, 1, 1) - 1.997291892549682) < close);
  BOOST_TEST(std::abs(ratio(100, 20, 1, 1) - 1.660016222598941) < close);
}

// With so many balls they are free each for itself.
BOOST_AUTO_TEST_CASE(flights_of_any_length_end_in_the_collisions_of_pairs_in_long_chains_too) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0.1, 1);
  for (int decade = 4; decade <= 100; decade += 6) {
    auto chain = equal_chain(60);
    for (double& mass : chain.mass) mass = unit(random);
    for (double& gap : chain.gap) gap = unit(random) * std::pow(10, decade);
    const auto pairs = impact::by_event(impact::chain_configuration(chain.mass, chain.velocity),
                                        {.restitution = Numbers(59, 1.0)}, chain.gap);
    BOOST_TEST_CONTEXT("gaps of 1e" << decade)
    BOOST_TEST(difference(impact::simulate(chain).velocity, pairs.velocity) < 1e-7);
  }
}

// Far apart the balls collide in pairs, one pair after the other, as instantaneous collisions say. A flight's
// rounding error is that of its height, here up to 10¹⁰⁰ times an indentation.
BOOST_AUTO_TEST_CASE(flights_of_any_length_end_in_the_collisions_of_pairs) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.1, 1);
  for (const auto* law : laws)
    for (int decade = 4; decade <= 100; ++decade) {
      auto chain = equal_masses({undamped(law, unit(random)), undamped(law, unit(random))},
                                {unit(random), 0, -unit(random)});
      for (double& mass : chain.mass) mass = unit(random);
      for (double& gap : chain.gap) gap = unit(random) * std::pow(10, decade);
      const auto pairs = impact::by_event(impact::chain_configuration(chain.mass, chain.velocity),
                                          {.restitution = {1, 1}}, chain.gap);
      BOOST_TEST_CONTEXT(law << " contacts, gaps of 1e" << decade) {
        BOOST_TEST(difference(impact::simulate(chain).velocity, pairs.velocity) < 1e-9);
        BOOST_TEST(difference(impact::simulate(model::as_network(chain)).velocity, pairs.velocity) < 1e-9);
      }
    }
}
