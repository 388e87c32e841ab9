// Processes that hang or crash are findings, and who examines a scene changes nothing.
#define BOOST_TEST_MODULE stress_study_workers
#include "workers.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <map>

#include "verdict_text.hpp"

using namespace mariotte::stress_study;

namespace {

Scene draw_for_ever(Dice& dice) {
  for (double sum = 0;; sum += dice.uniform(0, 1))
    if (sum < 0) return {};
}
Scene abort_at_once(Dice&) {
  std::abort();
}

std::map<std::uint64_t, Verdict> verdicts(const Campaign& campaign, std::uint64_t scenes) {
  std::map<std::uint64_t, Verdict> all;
  examine_all(
      campaign, [&](std::uint64_t scene) { return scene < scenes; },
      [&](const Verdict& verdict) { all[verdict.scene] = verdict; });
  return all;
}

std::vector<Family> first_two() {
  auto list = chain_families();
  list.resize(2);
  return list;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_rare_family_leaves_most_of_its_turns_to_others) {
  auto list = first_two();
  list[1].every = 10;
  std::size_t rare = 0;
  for (std::uint64_t number = 0; number < 200; ++number) rare += family_of(list, number);
  BOOST_TEST(rare == 10u);
}

BOOST_AUTO_TEST_CASE(scenes_go_on_where_another_start_has_stopped) {
  const auto later = verdicts({.families = first_two(), .seed = 5, .first = 6}, 10);
  BOOST_TEST(later.size() == 4u);
  BOOST_TEST(later.contains(6));
}

BOOST_AUTO_TEST_CASE(verdicts_depend_on_seed_and_number_alone) {
  const auto one = verdicts({.families = first_two(), .seed = 5, .workers = 1}, 40);
  const auto two = verdicts({.families = first_two(), .seed = 5, .workers = 3}, 40);
  BOOST_TEST_REQUIRE(one.size() == 40u);
  BOOST_TEST_REQUIRE(two.size() == 40u);
  for (const auto& [scene, verdict] : one) {
    BOOST_TEST(verdict.error == two.at(scene).error);
    BOOST_TEST(verdict.worst == two.at(scene).worst);
    BOOST_TEST(verdict.findings == two.at(scene).findings);
  }
}

BOOST_AUTO_TEST_CASE(a_brisk_campaign_leaves_out_what_takes_long) {
  const auto all = verdicts({.families = chain_families(), .seed = 5}, 24);
  const auto brisk = verdicts({.families = chain_families(), .seed = 5, .brisk = true}, 24);
  int left_out = 0;
  for (const auto& [scene, verdict] : brisk) {
    left_out += verdict.left_out;
    if (!verdict.left_out) BOOST_TEST(verdict.error == all.at(scene).error);
  }
  BOOST_TEST(left_out > 0);
  BOOST_TEST(left_out < 16);
}

BOOST_AUTO_TEST_CASE(a_scene_without_an_end_is_given_up_and_the_next_one_examined) {
  auto list = first_two();
  list.push_back({"endless", draw_for_ever});
  const auto all = verdicts({.families = list, .seed = 5, .workers = 1, .patience = 0.3}, 6);
  BOOST_TEST_REQUIRE(all.size() == 6u);
  BOOST_TEST(all.at(2).killed == 1);
  BOOST_TEST(all.at(2).findings.size() == 1u);
  BOOST_TEST(all.at(3).killed == 0);
}

BOOST_AUTO_TEST_CASE(a_crash_is_a_finding) {
  const auto all = verdicts({.families = {{"crash", abort_at_once}}, .seed = 5, .workers = 1}, 2);
  BOOST_TEST_REQUIRE(all.size() == 2u);
  BOOST_TEST(all.at(1).failures == 1);
  BOOST_TEST(all.at(1).findings[0].find("signal 6") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(verdicts_survive_the_way_between_processes) {
  const Verdict verdict{.scene = 7,
                        .error = {0.5, -1, 1e300},
                        .worst = mariotte::infinity,
                        .seconds = 0.25,
                        .naive = true,
                        .failures = 2,
                        .findings = {"a \"quoted\"\nword", "ζ"}};
  const auto again = unpacked(packed(verdict));
  BOOST_TEST(again.error == verdict.error);
  BOOST_TEST(again.worst > 1e300);
  BOOST_TEST(again.naive);
  BOOST_TEST(again.failures == 2);
  BOOST_TEST(again.findings == verdict.findings);
  const Verdict hopeless{.error = {mariotte::infinity, 1, 1}};
  BOOST_TEST(unpacked(packed(hopeless)).error[0] > 1e300);
}
