#define BOOST_TEST_MODULE command_uncertainty
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "session.hpp"

using support::has;
using support::Session;
using Json = nlohmann::json;

namespace {

const std::string triplet = std::string("uncertainty ") + MARIOTTE_SCENES + "/triplet.toml ";

}  // namespace

BOOST_FIXTURE_TEST_CASE(deviations_stand_beside_samples, Session) {
  const auto run = mariotte(triplet + "--set 'chain.velocity[0]=1 ± 1 %' --samples 500 --seed 3 --json");
  BOOST_TEST(run.code == 0);
  const auto result = Json::parse(run.out);
  BOOST_TEST(result["inputs"][0]["key"] == "chain.velocity[0]");
  BOOST_TEST(result["samples"] == 500);
  BOOST_TEST(result["seed"] == 3);
  BOOST_TEST(result["others"] == 0);
  for (const auto& outcome : result["outcomes"]) {
    if (outcome["unit"] != "m/s") continue;
    // Velocities are homogeneous in velocities.
    const double value = outcome["value"], deviation = outcome["deviation"],
                 sampled = outcome["sampled_deviation"];
    BOOST_TEST(std::abs(deviation - 0.01 * std::abs(value)) < 1e-9);
    BOOST_TEST(std::abs(sampled / deviation - 1) < 0.15);  // known to 3 %
  }
}

BOOST_FIXTURE_TEST_CASE(the_table_names_inputs_and_outcomes, Session) {
  const auto run = mariotte(triplet + "--set 'chain.velocity[0]=1 m/s +- 1 cm/s'");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.out, "chain.velocity[0] = 1 ± 0.01"));
  BOOST_TEST(has(run.out, "velocity[2]"));
}

BOOST_FIXTURE_TEST_CASE(samples_that_end_in_another_way_are_told_of, Session) {
  const std::string sphere = std::string("uncertainty ") + MARIOTTE_SCENES + "/microsphere.toml ";
  const auto run = mariotte(sphere + "--set 'incidence.normal_speed=1.3 m/s +- 5 %' --samples 200");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(
      has(run.out, " of 200 samples end in another way, have other contacts, or make no scene; means"));
}

BOOST_FIXTURE_TEST_CASE(a_scene_without_deviations_is_refused, Session) {
  const auto run = mariotte(triplet);
  BOOST_TEST(run.code == 2);
  BOOST_TEST(has(run.err, "no number of the scene has a deviation"));
}

BOOST_FIXTURE_TEST_CASE(an_outcome_that_there_is_not_is_told_so, Session) {
  const auto run = mariotte(triplet + "--set 'chain.velocity[0]=1 ± 1 %' --of speed");
  BOOST_TEST(run.code == 2);
  BOOST_TEST(has(run.err, "--of speed: no such outcome; there are velocity[0], "));
}

BOOST_FIXTURE_TEST_CASE(a_deviation_has_a_unit_where_its_value_has_one, Session) {
  const auto bare = mariotte(triplet + "--set 'chain.velocity[0]=100 cm/s ± 1'");
  BOOST_TEST(bare.code == 3);
  BOOST_TEST(has(bare.err, "--set chain.velocity[0]"), bare.err);
  BOOST_TEST(has(bare.err, "the deviation '1' has no unit: write '1 cm/s', or per cent [S020]"), bare.err);
  BOOST_TEST(mariotte(triplet + "--set 'chain.velocity[0]=100 cm/s ± 1 %'").code == 0);
}

BOOST_FIXTURE_TEST_CASE(whole_numbers_are_decimal_whatever_they_begin_with, Session) {
  const std::string uncertain = triplet + "--set 'chain.velocity[0]=1 ± 1 %' --json ";
  const auto result = nlohmann::json::parse(mariotte(uncertain + "--samples 0100 --seed 010").out);
  BOOST_TEST(result["samples"] == 100);
  BOOST_TEST(result["seed"] == 10);
  for (const char* wrong : {"99999999999999999999999", "0x10"}) {
    const auto run = mariotte(uncertain + "--samples 10 --seed " + wrong);
    BOOST_TEST(support::is_refused(run));
    BOOST_TEST(has(run.err, wrong), run.err);
  }
}

BOOST_FIXTURE_TEST_CASE(a_seed_is_one_of_samples_and_not_negative, Session) {
  const std::string uncertain = triplet + "--set 'chain.velocity[0]=1 ± 1 %' ";
  const auto negative = mariotte(uncertain + "--samples 10 --seed -1");
  BOOST_TEST(support::is_refused(negative));
  BOOST_TEST(has(negative.err, "--seed: must not be negative, but is -1"), negative.err);
  const auto alone = mariotte(uncertain + "--seed 7");
  BOOST_TEST(support::is_refused(alone));
  BOOST_TEST(has(alone.err, "--seed requires --samples"), alone.err);
}
