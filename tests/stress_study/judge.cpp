// What is wrong is seen, what is explained is not reported.
#define BOOST_TEST_MODULE stress_study_judge
#include "judge.hpp"

#include <boost/test/unit_test.hpp>

#include "family.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte;
using namespace mariotte::stress_study;

namespace {

const Scene three_balls{.model = model::Chain{.mass = {1, 1, 1},
                                              .law = {contact::Hertz{1}, contact::Hertz{1}},
                                              .gap = {0, 0},
                                              .velocity = {1, 0, 0}}};

Trial trial(const Scene& scene, double accuracy) {
  const Method method{.flow = "auto", .accuracy = accuracy, .balances = true};
  return {.name = name(method), .accuracy = accuracy, .found = run(scene, method), .counts = true};
}

Measure amplified(double amplification, bool counts_change = false) {
  return [=](double, double) { return Sensitivity{amplification, counts_change}; };
}

Judgement judged(const Trial& one, const Measure& measure = amplified(1)) {
  return judge(trial(three_balls, 1e-12), {one}, measure);
}

}  // namespace

BOOST_AUTO_TEST_CASE(right_results_leave_no_findings) {
  const auto judgement = judged(trial(three_balls, 1e-10));
  BOOST_TEST(judgement.findings.empty());
  BOOST_TEST(judgement.worst < 1);
}

BOOST_AUTO_TEST_CASE(a_wrong_velocity_is_found_unless_perturbations_explain_it) {
  auto wrong = trial(three_balls, 1e-10);
  wrong.found.value[1] += 1e-7;
  const auto judgement = judged(wrong);
  BOOST_TEST_REQUIRE(judgement.findings.size() == 1u);
  BOOST_TEST(judgement.findings[0].find("differ by 1e-07") != std::string::npos);
  BOOST_TEST(judgement.worst > 900);
  BOOST_TEST(judged(wrong, amplified(50)).findings.size() == 1u);
  BOOST_TEST(judged(wrong, amplified(200)).findings.empty());
}

BOOST_AUTO_TEST_CASE(what_is_not_a_number_is_found) {
  auto wrong = trial(three_balls, 1e-10);
  wrong.found.value[2] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(judged(wrong, amplified(mariotte::infinity)).findings.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_missed_contact_is_found_unless_it_is_a_graze) {
  auto wrong = trial(three_balls, 1e-10);
  ++wrong.found.periods[0];
  BOOST_TEST(judged(wrong).counts_differ);
  BOOST_TEST(judged(wrong).findings.empty());  // it brings no impulse
  wrong.found.impulse[0] -= 1e-6;
  BOOST_TEST(judged(wrong).findings.size() == 1u);
  BOOST_TEST(judged(wrong, amplified(1, true)).findings.empty());
}

BOOST_AUTO_TEST_CASE(an_open_balance_is_found) {
  auto wrong = trial(three_balls, 1e-10);
  wrong.found.imbalance = 1e-6;
  BOOST_TEST(judged(wrong).findings.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_largest_force_off_its_law_is_found) {
  auto wrong = trial(three_balls, 1e-10);
  BOOST_TEST(wrong.found.peak_misfit < 1e-6);
  wrong.found.peak_misfit = 0.01;
  BOOST_TEST(judged(wrong).findings.size() == 1u);
}

BOOST_AUTO_TEST_CASE(failures_and_limits_are_found_and_refusals_counted) {
  auto wrong = trial(three_balls, 1e-10);
  for (const auto ending : {hybrid::Ending::failed, hybrid::Ending::unsure}) {
    wrong.found.ending = ending;
    BOOST_TEST(judged(wrong).failures == 1);
    BOOST_TEST(judged(wrong).findings.size() == 1u);
  }
  wrong.found.ending = hybrid::Ending::event_limit;
  BOOST_TEST(judged(wrong).limits == 1);
  BOOST_TEST(judged(wrong).findings.size() == 1u);
  wrong.many_events = true;
  BOOST_TEST(judged(wrong).limits == 1);
  BOOST_TEST(judged(wrong).findings.empty());
  wrong.found.refused = true;
  BOOST_TEST(judged(wrong).refusals == 1);
  BOOST_TEST(judged(wrong).findings.empty());
}

BOOST_AUTO_TEST_CASE(a_body_that_is_captured_in_one_run_only_is_found) {
  auto wrong = trial(three_balls, 1e-10);
  wrong.found.ending = hybrid::Ending::captured;
  BOOST_TEST(judged(wrong).findings.size() == 1u);
}

// A wall of which the forces are left out: what the naive simulator is there to see.
BOOST_AUTO_TEST_CASE(the_naive_simulator_contradicts_a_ball_that_fell_through_the_floor) {
  const Scene scene{.model = model::Chain{.mass = {infinity, 1},
                                          .law = {contact::Linear{10}},
                                          .gap = {0},
                                          .velocity = {0, 0},
                                          .gravity = 1},
                    .max_time = 5};
  auto best = trial(scene, 1e-12);
  const auto naive = run_naively(scene, 5, {});
  BOOST_TEST_REQUIRE(naive.has_value());
  const Trial right{.name = "naive simulator", .accuracy = 1e-7, .found = *naive};
  BOOST_TEST(judge(best, {right}, amplified(1)).findings.empty());
  best.found.value[1] = 0;  // fell freely: v + g t
  BOOST_TEST(judge(best, {right}, amplified(1)).findings.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_scene_file_repeats_its_scene_to_the_last_digit) {
  const auto list = families({"chains", "networks", "bodies"});
  for (std::uint64_t number = 0; number < 4 * list.size(); ++number) {
    const auto scene = scene_of(list, 3, number);
    const auto again = scene::parse(text(scene, 1e-10, "two\nlines"), "scene");
    BOOST_TEST_CONTEXT(list[family_of(list, number)].name << ", scene " << number) {
      if (const auto* chain = std::get_if<model::Chain>(&scene.model)) {
        BOOST_TEST(std::get<model::Chain>(again.model).mass == chain->mass);
        BOOST_TEST(std::get<model::Chain>(again.model).velocity == chain->velocity);
        BOOST_TEST(std::get<model::Chain>(again.model).gap == chain->gap);
        BOOST_TEST(std::get<model::Chain>(again.model).gravity == chain->gravity);
        for (std::size_t j = 0; j < chain->law.size(); ++j)
          BOOST_TEST(contact::stiffness(std::get<model::Chain>(again.model).law[j]) ==
                     contact::stiffness(chain->law[j]));
      }
      if (const auto* network = std::get_if<model::Network>(&scene.model)) {
        BOOST_TEST(std::get<model::Network>(again.model).mass == network->mass);
        BOOST_TEST(std::get<model::Network>(again.model).velocity == network->velocity);
        BOOST_TEST(std::get<model::Network>(again.model).gap == network->gap);
      }
    }
  }
}
