// Pairs and chains with every named law, against numbers computed in extended precision elsewhere: velocities
// to 1e-9 of the largest at accuracy 1e-10, the same events in the same order, and times to 1e-8.
#define BOOST_TEST_MODULE reference laws
#include <boost/test/unit_test.hpp>

#include "support/reference_laws.hpp"

using namespace mariotte;
using hybrid::Ending;

namespace {

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

void check_events(const impact::ContactImpact& impact, const nlohmann::json& c) {
  const auto found = test::events_of(impact), expected = test::events_of(c);
  BOOST_TEST_REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    BOOST_TEST(found[i].what == expected[i].what);
    BOOST_TEST(found[i].contact == expected[i].contact);
    BOOST_TEST(std::abs(found[i].time - expected[i].time) <= 1e-8 * expected.back().time);
  }
}

/// Losses are there, none is negative, and together with the energies they balance.
void check_energies(const impact::EnergyBalance& energy) {
  const double noise = 1e-8 * (energy.initial + std::abs(energy.stored));
  BOOST_TEST(std::abs(energy.residual) <= noise);
  BOOST_TEST(energy.plastic >= -noise);
  BOOST_TEST(energy.adhesion >= -noise);
  BOOST_TEST(energy.dissipated - energy.plastic - energy.adhesion >= -noise);
}

double worst_pair = 0, worst_chain = 0;

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_are_those_of_the_references) {
  for (const auto& c : test::law_cases("pairs.json")) {
    const auto chain = test::chain_of(c);
    const auto impact = impact::simulate(chain, {.accuracy = 1e-10});
    BOOST_TEST_CONTEXT(c.at("family") << " at " << largest(chain.velocity) << " m/s: " << impact.message) {
      const bool bound = c.at("ending") == "captured";
      BOOST_TEST((impact.ending == (bound ? Ending::bound : Ending::separated)), name(impact.ending));
      check_events(impact, c);
      check_energies(impact.energy);
      if (bound) continue;
      const auto expected = test::sizes(c.at("velocity_after"));
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const double error = std::abs(impact.velocity[i] - expected[i]) / largest(expected);
        BOOST_TEST(error <= 1e-9);
        worst_pair = std::max(worst_pair, error);
      }
      const auto& contact = impact.contacts[0];
      const double depth = c.at("peak_indentation");
      BOOST_TEST(std::abs(contact.peak_indentation - depth) <= 1e-9 * depth);
      BOOST_TEST(std::abs(contact.permanent_indentation - c.at("permanent_indentation").get<double>()) <=
                 1e-9 * depth);
    }
  }
  BOOST_TEST_MESSAGE("largest error of a pair: " << worst_pair);
}

BOOST_AUTO_TEST_CASE(chains_are_those_of_the_references) {
  for (const auto& c : test::law_cases("chains.json")) {
    const auto chain = test::chain_of(c);
    const bool stays = c.at("ending") == "time";
    const auto impact = impact::simulate(
        chain, {.accuracy = 1e-10, .max_time = stays ? c.at("end_time").get<double>() : infinity});
    BOOST_TEST_CONTEXT(chain.mass.size() << " balls: " << impact.message) {
      BOOST_TEST((impact.ending == (stays ? Ending::time_limit : Ending::separated)), name(impact.ending));
      check_events(impact, c);
      check_energies(impact.energy);
      const auto velocity = test::sizes(c.at("velocity_after")), impulse = test::sizes(c.at("impulse"));
      const auto end = test::sizes(c.at("indentation_end")),
                 dent = test::sizes(c.at("permanent_indentation"));
      for (std::size_t i = 0; i < velocity.size(); ++i) {
        const double error = std::abs(impact.velocity[i] - velocity[i]) / largest(velocity);
        BOOST_TEST(error <= 1e-9);
        worst_chain = std::max(worst_chain, error);
      }
      for (std::size_t j = 0; j < impulse.size(); ++j) {
        BOOST_TEST(std::abs(impact.contacts[j].impulse - impulse[j]) <= 1e-9 * largest(impulse));
        BOOST_TEST(std::abs(impact.contacts[j].permanent_indentation - dent[j]) <= 1e-9 * (1 + dent[j]));
        if (stays) BOOST_TEST(std::abs(-impact.gap[j] - end[j]) <= 1e-8 * largest(end));
      }
    }
  }
  BOOST_TEST_MESSAGE("largest error of a chain: " << worst_chain);
}
