#define BOOST_TEST_MODULE rows at rest under gravity
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/promise.hpp"
#include "support/custom_power_law.hpp"
#include "support/naive_chain.hpp"

using namespace mariotte;
using hybrid::Ending;

namespace {

const contact::Law hertz = contact::Hertz{1};

model::Chain resting(std::size_t balls, const contact::Law& law, double gravity = 0.1) {
  model::Chain chain{.mass = std::vector<double>(balls + 1, 1.0),
                     .law = std::vector<contact::Law>(balls, law),
                     .gap = std::vector<double>(balls),
                     .velocity = std::vector<double>(balls + 1),
                     .gravity = gravity};
  chain.mass[0] = infinity;
  return chain;
}

std::vector<double> velocities(const model::Chain& chain, double end, double accuracy,
                               const char* flow = "auto") {
  const auto impact =
      impact::simulate(chain, {.accuracy = accuracy, .max_time = end, .flow = flow::parse_kind(flow)});
  BOOST_TEST((impact.ending == Ending::time_limit), impact.message);
  return impact.velocity;
}

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  return impact::difference(a, b, 0);
}

/// By the naive simulator, which shares nothing with the flows.
void expect_as_naive(const model::Chain& chain, double end, double speed) {
  const auto naive = test::run_naive(test::naive_contacts(chain), {.end = end, .speed = speed});
  BOOST_TEST_REQUIRE(naive.complete);
  for (const double accuracy : {1e-7, 1e-10, 1e-13})
    BOOST_TEST(apart(velocities(chain, end, accuracy), naive.velocity) < 2e-7 * speed);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_resting_row_is_held_by_its_floor) {
  const auto chain = resting(3, hertz);
  const std::vector<double> expected = {0, -0.0980118095539, -0.1922038292018, -0.4478301007930};
  for (const double accuracy : {1e-8, 1e-10, 1e-12})
    BOOST_TEST(apart(velocities(chain, 5, accuracy), expected) < 1e-12 + 10 * accuracy);
  expect_as_naive(chain, 5, 1);
}

BOOST_AUTO_TEST_CASE(damped_rows_and_rows_of_other_exponents_are_held_too) {
  for (const double exponent : {1.0, 1.2, 1.5, 2.0, 2.7})
    for (const double damping : {0.0, 0.2})
      expect_as_naive(
          resting(3, contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = exponent}), 5, 1);
}

BOOST_AUTO_TEST_CASE(a_long_row_in_islands_is_held_too) {
  expect_as_naive(resting(60, hertz), 5, 1);
}

BOOST_AUTO_TEST_CASE(a_ball_rests_on_the_floor_while_others_fly) {
  const model::Chain chain{
      .mass = {infinity, 1, 0.6, 1.7, infinity},
      .law = {contact::Hertz{1000}, contact::Hertz{2000}, contact::Hertz{1000}, contact::Hertz{3000}},
      .gap = {0, 0.05, 0.05, 0.1},
      .velocity = {0, 0, 1.5, -0.5, 0},
      .gravity = 9.81};
  BOOST_TEST(apart(velocities(chain, 0.5, 1e-10), {0, 0.15424, 3.24574, 0.55163, 0}) < 5e-6);
  expect_as_naive(chain, 0.5, 1.5);
}

BOOST_AUTO_TEST_CASE(balls_of_steel_at_rest_are_struck_from_above) {
  const double k = 5.3e9;  // about that of steel balls of 10 mm
  model::Chain chain = resting(4, contact::Hertz{k}, 9.81);
  for (std::size_t i = 1; i < chain.mass.size(); ++i) chain.mass[i] = 0.0327;
  chain.gap = {0, 0, 0, 1e-3};
  chain.velocity = {0, 0, 0, 0, -1};
  BOOST_TEST(apart(velocities(chain, 1.2e-3, 1e-10), velocities(chain, 1.2e-3, 1e-10, "cvode-adams")) < 1e-8);
}

BOOST_AUTO_TEST_CASE(random_rows_at_rest_agree_with_the_naive_simulator) {
  std::mt19937_64 random(17);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  for (int scene = 0; scene < 40; ++scene) {
    auto chain = resting(static_cast<std::size_t>(2 + scene % 6), hertz, uniform(0.05, 1));
    for (std::size_t i = 1; i < chain.mass.size(); ++i) chain.mass[i] = std::pow(10, uniform(-0.5, 0.5));
    for (auto& law : chain.law) law = contact::Hertz{std::pow(10, uniform(-0.5, 0.5))};
    if (scene % 3 == 1) chain.velocity.back() = -1;
    if (scene % 3 == 2) chain.gap.back() = 0.2;
    expect_as_naive(chain, 6, 2);
  }
}

// The contact comes to δ = 0 with δ̇ = 0 and turns there: a root series goes on as t, the root as |t|.
BOOST_AUTO_TEST_CASE(a_ball_at_rest_on_a_floor_keeps_its_energy) {
  const auto chain = resting(1, contact::Hertz{10}, 1);
  for (const double accuracy : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13})
    BOOST_TEST(std::abs(velocities(chain, 20, accuracy)[1] + 0.012764132797788) < accuracy);
}

BOOST_AUTO_TEST_CASE(a_ball_at_rest_stays_in_contact_for_many_returns) {
  const auto chain = resting(1, hertz);
  const auto reference = velocities(chain, 60, 1e-14)[1];
  for (const double accuracy : {1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-13})
    BOOST_TEST(std::abs(velocities(chain, 60, accuracy)[1] - reference) < accuracy);
}

// At first the force of the floor is a power of time, whose series ends: what follows is rounding, or nothing
// at all. On processors without AVX2 steps as short as the quotient of such coefficients followed each other
// for ever, and others were so long that a contact opened.
BOOST_AUTO_TEST_CASE(rows_at_rest_begin_with_steps_of_the_right_length) {
  std::mt19937_64 random(18);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  for (int scene = 0; scene < 200; ++scene) {
    auto chain = resting(2, contact::Hertz{std::pow(10, uniform(4, 8))}, scene % 2 ? 9.81 : 1);
    chain.mass = {infinity, uniform(0.01, 0.03), 0.02};
    const auto impact = impact::simulate(chain, {.accuracy = 1e-13, .max_time = 0.02});
    const auto add = [](Index sum, const impact::FlowUse& one) { return sum + one.steps; };
    BOOST_TEST(std::accumulate(impact.flows.begin(), impact.flows.end(), Index{0}, add) < 3000);
    BOOST_TEST(apart(impact.velocity, velocities(chain, 0.02, 1e-9)) < 1e-9);
  }
}

// Ball 2 touches a wall on its right, falls to the left and is struck back. Its contact carries no force
// before that, whichever flow follows; runs are good to 1e-10.
BOOST_AUTO_TEST_CASE(what_gravity_draws_apart_closes_once_it_is_struck_back) {
  for (const contact::PowerLaw& law :
       {contact::PowerLaw(contact::Hertz{1}), contact::PowerLaw(contact::Linear{1}),
        contact::PowerLaw{1, 0.2, 1.5}}) {
    model::Chain chain{
        .mass = {1, 1, infinity}, .law = {law, law}, .gap = {0, 0}, .velocity = {1, 0, 0}, .gravity = 0.3};
    const auto by_series = impact::simulate(chain);
    chain.law.assign(2, test::custom(law));
    const auto by_cvode = impact::simulate(chain);
    BOOST_TEST(by_series.contacts[1].periods.size() == 1u);
    BOOST_TEST(by_cvode.contacts[1].periods.size() == 1u);
    BOOST_TEST(std::abs(by_series.contacts[1].periods.back().start -
                        by_cvode.contacts[1].periods.back().start) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(what_has_not_begun_is_not_over) {
  auto chain = resting(2, contact::Hertz{1e9}, 9.81);
  chain.gap = {0, 0.01};
  const auto impact = impact::simulate(chain);
  BOOST_TEST((impact.ending == Ending::separated));
  BOOST_TEST(impact.time > std::sqrt(2 * 0.01 / 9.81));
  BOOST_TEST(impact.velocity[2] > 0.4);
}

BOOST_AUTO_TEST_CASE(walls_that_approach_each_other_need_a_limit) {
  const model::Chain chain{
      .mass = {infinity, 1, infinity}, .law = {hertz, hertz}, .gap = {0.5, 0.5}, .velocity = {1, 0, -1}};
  BOOST_CHECK_THROW(impact::simulate(chain), InvalidParameter);
  BOOST_CHECK_THROW(impact::ChainSolver().solve(chain), InvalidParameter);
  BOOST_TEST((impact::simulate(chain, {.max_time = 0.75}).ending == Ending::time_limit));
}
