// Contacts that nearly let go, or do so for less than a step. Scene i can be repeated alone:
// grazing_scene(i).
#define BOOST_TEST_MODULE grazes
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <iostream>

#include "support/graze_campaign.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// To within 1e-11: ten times below the shallowest graze of the campaign, in the same units.
void check_oracle(const model::Chain& chain, const nlohmann::json& c) {
  Oracle oracle(chain);
  const auto truth = oracle.truth();
  BOOST_TEST(truth.complete);
  BOOST_TEST(difference(oracle.velocity(), c.at("final")) < 1e-11);
  if (!c.contains("periods")) return;
  for (std::size_t j = 0; j < truth.periods.size(); ++j)
    BOOST_TEST(truth.periods[j] == c.at("periods")[j].size());
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_oracle_knows_the_reference_chains) {
  for (const auto& c : cases("triplets.json"))
    BOOST_TEST_CONTEXT("triplet " << c) check_oracle(triplet(c), c);
  for (const auto& c : cases("linear_triplets.json")) {
    if (c.at("kappa") > 1e4) continue;  // far outside the stiffnesses of the campaign, and slow
    BOOST_TEST_CONTEXT("linear triplet " << c) check_oracle(linear_triplet(c), c);
  }
  for (const auto& c : cases("viscoelastic.json")) {
    if (!c.contains("final")) continue;
    BOOST_TEST_CONTEXT("viscoelastic " << c)
    check_oracle(equal_masses({viscoelastic(c), viscoelastic(c)}, {1, 0, 0}), c);
  }
}

BOOST_AUTO_TEST_CASE(the_grazes_are_as_deep_as_they_say) {
  for (std::size_t i = 0; i < 100; ++i) {
    const auto scene = grazing_scene(i);
    const std::size_t periods = scene.truth.periods[scene.contact];
    const auto is_the_graze = [&](const Turn& turn) {
      return turn.probe.contact == scene.contact &&
             std::abs(std::abs(turn.value) + scene.depth) <= 2e-3 * std::abs(scene.depth);
    };
    const auto& turns = scene.truth.turns;
    BOOST_TEST_CONTEXT("scene " << i) {
      if (scene.depth > 0)
        BOOST_TEST(periods >= (scene.graze == Graze::ceiling ? 1u : 2u));
      else
        BOOST_TEST((std::find_if(turns.begin(), turns.end(), is_the_graze) != turns.end()));
    }
  }
}

BOOST_AUTO_TEST_CASE(no_graze_is_missed_and_none_invented) {
  const auto campaign = run_campaign(500, {"auto", "taylor", "cvode-adams"});
  std::cout << campaign;
  BOOST_TEST(campaign.losing > 200u);
  BOOST_TEST(campaign.keeping > 200u);
  for (const auto& scene : campaign.wrong) BOOST_ERROR(scene);
}

BOOST_AUTO_TEST_CASE(implicit_flows_see_every_graze_too) {
  const auto campaign = run_campaign(24, {"cvode-bdf-dense", "cvode-bdf-band", "cvode-bdf-klu"});
  std::cout << campaign;
  for (const auto& scene : campaign.wrong) BOOST_ERROR(scene);
}
