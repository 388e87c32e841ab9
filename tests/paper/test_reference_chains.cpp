#define BOOST_TEST_MODULE reference chains
#include <boost/test/unit_test.hpp>

#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

constexpr hybrid::Options to_1e10{.accuracy = 1e-10};
constexpr double allowed = 1e-9;  // of velocities and impulses, in units of v₁ and m v₁

void check_outcome(const impact::ChainImpact& impact, const nlohmann::json& c) {
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_TEST(difference(impact.velocity, c.at("final")) < allowed);
  if (!c.at("impulse").is_null()) BOOST_TEST(difference(impulses(impact), c.at("impulse")) < allowed);
}

void check_counts(const impact::ChainImpact& impact, const std::vector<std::size_t>& expected) {
  BOOST_TEST(period_counts(impact) == expected, boost::test_tools::per_element());
}

/// Period by period; the first onset of a contact that touches at rest is 0 by definition and not compared.
void check_periods(const impact::ChainImpact& impact, const nlohmann::json& contacts) {
  for (std::size_t j = 0; j < contacts.size(); ++j)
    for (std::size_t i = 0; i < contacts[j].size(); ++i) {
      const double start = contacts[j][i][0], end = contacts[j][i][1];
      if (start > 1e-3)
        BOOST_TEST(std::abs(impact.contacts[j].periods[i].start - start) < 1e-8 * (1 + start));
      BOOST_TEST(std::abs(*impact.contacts[j].periods[i].end - end) < 1e-8 * (1 + end));
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(triplets_of_any_stiffness_ratio_and_third_velocity) {
  for (const auto& c : cases("triplets.json")) {
    BOOST_TEST_CONTEXT(c.at("law") << " kappa " << c.at("kappa") << " velocity " << c.at("velocity")) {
      const auto impact = impact::simulate(triplet(c), to_1e10);
      check_outcome(impact, c);
      check_counts(impact, {c.at("periods")[0].size(), c.at("periods")[1].size()});
      check_periods(impact, c.at("periods"));
    }
  }
}

BOOST_AUTO_TEST_CASE(linear_triplets_up_to_a_stiffness_ratio_of_1e4) {
  for (const auto& c : cases("linear_triplets.json")) {
    if (c.at("kappa") > 1e4) continue;
    BOOST_TEST_CONTEXT("kappa " << c.at("kappa")) {
      const auto impact = impact::simulate(linear_triplet(c), to_1e10);
      check_outcome(impact, c);
      BOOST_TEST(impact.time == c.at("time").get<double>(), boost::test_tools::tolerance(1e-8));
    }
  }
}

BOOST_AUTO_TEST_CASE(equal_chains_of_3_to_21_balls) {
  for (const auto& c : cases("equal_chains.json")) {
    BOOST_TEST_CONTEXT(c.at("n") << " balls") {
      const auto impact = impact::simulate(equal_chain(c.at("n")), to_1e10);
      check_outcome(impact, c);
      check_counts(impact, c.at("periods"));
      const Numbers expected = c.at("icr");
      for (std::size_t j = 0; j < expected.size(); ++j)
        BOOST_TEST(std::abs(*impact.icr[j] - expected[j]) < allowed);
    }
  }
}

BOOST_AUTO_TEST_CASE(chains_with_a_big_ball) {
  for (const auto& c : cases("big_ball_chains.json")) {
    BOOST_TEST_CONTEXT(c.at("name")) {
      const auto impact = impact::simulate(big_ball_chain(c.at("radius")), to_1e10);
      check_outcome(impact, c);
      if (c.contains("periods")) check_counts(impact, c.at("periods"));
      const Numbers expected = c.at("icr");
      for (std::size_t j = 0; j < expected.size(); ++j)
        BOOST_TEST(*impact.icr[j] == expected[j], boost::test_tools::tolerance(1e-7));
    }
  }
}

BOOST_AUTO_TEST_CASE(viscoelastic_triplets_let_go_when_the_force_is_zero) {
  for (const auto& c : cases("viscoelastic.json")) {
    if (!c.contains("final")) continue;
    BOOST_TEST_CONTEXT("exponent " << c.at("exponent") << " damping " << c.at("damping")) {
      const auto law = viscoelastic(c);
      const auto impact = impact::simulate(equal_masses({law, law}, {1, 0, 0}), to_1e10);
      check_outcome(impact, c);
      check_counts(impact, {1, 1});
      check_periods(impact, c.at("periods"));
      BOOST_TEST(std::abs(*impact.energy.ratio_lab - c.at("energy_ratio").get<double>()) < allowed);
    }
  }
}

BOOST_AUTO_TEST_CASE(viscoelastic_pairs_have_the_known_restitution) {
  for (const auto& c : cases("viscoelastic.json")) {
    if (!c.contains("restitution")) continue;
    BOOST_TEST_CONTEXT("exponent " << c.at("exponent") << " damping " << c.at("damping")) {
      const auto impact = impact::simulate(equal_masses({viscoelastic(c)}, {1, 0}), to_1e10);
      const double restitution = impact.velocity[1] - impact.velocity[0];
      BOOST_TEST(std::abs(restitution - c.at("restitution").get<double>()) < allowed);
      BOOST_TEST(std::abs(impact.time - c.at("time").get<double>()) < 1e-8);
    }
  }
}
