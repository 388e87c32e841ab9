#define BOOST_TEST_MODULE the promise of an accuracy
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/promise.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

using namespace mariotte;

namespace {

/// Balls between heavy ones at both ends: each contact closes again and again.
model::Chain rattling(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  model::Chain chain;
  const int balls = 7 + static_cast<int>(seed % 3);
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(std::pow(10, uniform(-0.7, 0.7)));
    chain.velocity.push_back(uniform(-1, 1));
  }
  chain.mass.front() = chain.mass.back() = 20;
  chain.velocity.front() = 0.5;
  chain.velocity.back() = -0.5;
  for (int j = 0; j + 1 < balls; ++j) {
    chain.law.push_back(contact::Hertz{std::pow(10, uniform(-1, 1))});
    chain.gap.push_back(uniform(0, 1));
  }
  return chain;
}

}  // namespace

BOOST_AUTO_TEST_CASE(tighter_runs_are_asked_for_as_the_difference_says) {
  using impact::next_accuracy;
  constexpr double attainable = 16 * epsilon;
  BOOST_TEST(next_accuracy(1e-8, 1e-8, std::nullopt, attainable).value() < 1e-9);
  BOOST_TEST(next_accuracy(1e-8, 1e-8, 1e-6, attainable).value() < 1e-11);
  BOOST_TEST(!next_accuracy(1e-15, attainable, 1e-12, attainable));
  BOOST_TEST(next_accuracy(1e-8, 1e-8, 1e-6, 2e-9).value() == 2e-9);
  BOOST_TEST(!next_accuracy(1e-8, 2e-9, 1e-6, 2e-9));
}

BOOST_AUTO_TEST_CASE(runs_stop_when_two_agree) {
  int runs = 0;
  const auto last = impact::keep_promise({.accuracy = 1e-8}, 16 * epsilon, [&](const hybrid::Options&) {
    return std::optional(++runs < 2 ? 1e-6 : 1e-9);
  });
  BOOST_TEST(runs == 2);
  BOOST_TEST(last.value() == 1e-9);
}

BOOST_AUTO_TEST_CASE(two_runs_that_are_the_same_say_nothing) {
  BOOST_TEST(!impact::keep_promise({.accuracy = 1e-8}, 16 * epsilon,
                                   [](const hybrid::Options&) { return std::optional(0.0); }));
}

BOOST_AUTO_TEST_CASE(a_run_that_fails_leaves_the_one_before) {
  BOOST_TEST(!impact::keep_promise({.accuracy = 1e-8}, 16 * epsilon,
                                   [](const hybrid::Options&) { return std::optional<double>(); }));
}

BOOST_AUTO_TEST_CASE(what_is_not_a_number_never_agrees) {
  const std::vector<double> right = {1, 2}, wrong = {std::numeric_limits<double>::quiet_NaN(), 2};
  BOOST_TEST(impact::difference(right, wrong, 1) == infinity);
  BOOST_TEST(impact::difference(wrong, right, 0) == infinity);
  BOOST_TEST(impact::difference(right, {{1, 2.5}}, 2) == 0.25);
}

BOOST_AUTO_TEST_CASE(a_run_that_balances_is_not_replaced_by_one_that_does_not) {
  using hybrid::Ending;
  BOOST_TEST(impact::may_replace(Ending::separated, Ending::separated));
  BOOST_TEST(impact::may_replace(Ending::unsure, Ending::separated));
  BOOST_TEST(impact::may_replace(Ending::unsure, Ending::unsure));
  BOOST_TEST(!impact::may_replace(Ending::separated, Ending::unsure));
  BOOST_TEST(!impact::may_replace(Ending::separated, Ending::interrupted));
  BOOST_TEST(!impact::may_replace(Ending::separated, Ending::failed));
}

BOOST_AUTO_TEST_CASE(a_single_wave_is_run_once) {
  model::Chain chain{.mass = std::vector<double>(21, 1.0),
                     .law = std::vector<contact::Law>(20, contact::Hertz{1}),
                     .gap = std::vector<double>(20),
                     .velocity = std::vector<double>(21)};
  chain.velocity[0] = 1;
  BOOST_TEST(!impact::simulate(chain).estimated_accuracy);
  BOOST_TEST(!impact::ChainSolver().solve(chain).estimated_accuracy);
}

BOOST_AUTO_TEST_CASE(contacts_that_close_again_and_again_keep_the_accuracy) {
  int checked = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const auto chain = rattling(seed);
    const auto truth = impact::simulate(chain, {.accuracy = 1e-14});
    for (const double accuracy : {1e-7, 1e-10}) {
      const auto impact = impact::simulate(chain, {.accuracy = accuracy});
      if (!impact.estimated_accuracy || *impact.estimated_accuracy > accuracy) continue;
      ++checked;
      const double error = impact::difference(impact.velocity, truth.velocity, model::reference_speed(chain));
      BOOST_TEST(error <= accuracy, "seed " << seed << ": " << error << " at " << accuracy);
      const auto brief = impact::ChainSolver().solve(chain, {.accuracy = accuracy});
      BOOST_TEST(impact::difference(brief.velocity, impact.velocity, 0) < accuracy);
    }
  }
  BOOST_TEST(checked > 60);
}
