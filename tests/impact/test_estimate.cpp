// What runs say of their own errors, beside what these are: rows in extended precision are the truth.
#define BOOST_TEST_MODULE estimates of errors
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/impact/another_flow.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"
#include "support/extended_row.hpp"

using namespace mariotte;

namespace {

/// Balls between heavy ones at both ends, all apart at the start.
model::Chain rattling(unsigned seed, bool linear) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const std::size_t balls = 4 + seed % 6;
  const double heavy = std::pow(10, uniform(0.5, balls > 6 ? 2.5 : 4.5)), spread = uniform(0.1, 1);
  model::Chain chain;
  for (std::size_t i = 0; i < balls; ++i) {
    chain.mass.push_back(std::pow(10, uniform(-spread, spread)));
    chain.velocity.push_back(uniform(-1, 1));
  }
  chain.mass.front() = chain.mass.back() = heavy;
  chain.velocity.front() = 0.5;
  chain.velocity.back() = -0.5;
  for (std::size_t j = 0; j + 1 < balls; ++j) {
    const double stiffness = std::pow(10, uniform(-1, 1));
    linear ? chain.law.push_back(contact::Linear{stiffness}) : chain.law.push_back(contact::Hertz{stiffness});
    chain.gap.push_back(uniform(0, 1));
  }
  return chain;
}

/// Error of a result, relative to the largest incident speed.
double error(const model::Chain& chain, const impact::ChainImpact& impact, const test::ExtendedEnd& truth) {
  double most = 0;
  for (std::size_t i = 0; i < truth.velocity.size(); ++i)
    most = std::max(most, static_cast<double>(std::abs(impact.velocity[i] - truth.velocity[i])));
  return most / model::reference_speed(chain);
}

Index periods(const impact::ChainImpact& impact) {
  Index sum = 0;
  for (const auto& contact : impact.contacts) sum += std::ssize(contact.periods);
  return sum;
}

/// Estimates of both kinds are no smaller than the error, and the one that is asked for is of some use.
void expect_honest(const model::Chain& chain, const test::ExtendedEnd& truth, double accuracy) {
  const auto impact = impact::simulate(chain, {.accuracy = accuracy});
  BOOST_TEST_REQUIRE(periods(impact) == truth.periods);
  const double wrong = error(chain, impact, truth);
  const double estimate = impact::estimate_accuracy(chain, {.accuracy = accuracy}, impact);
  BOOST_TEST_CONTEXT("accuracy " << accuracy << ", error " << wrong << ", estimate " << estimate) {
    BOOST_TEST(impact.estimated_accuracy.value_or(infinity) >= wrong);
    BOOST_TEST(estimate >= wrong);
    BOOST_TEST(estimate <= 300 * std::max(wrong, 1e-13));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_estimate_is_smaller_than_the_error) {
  for (unsigned seed = 0; seed < 24; ++seed) BOOST_TEST_CONTEXT("seed " << seed) {
      const auto chain = rattling(seed, seed % 4 == 3);
      const auto truth = test::ExtendedRow(chain).run();
      for (const double accuracy : {1e-6, 1e-10, 1e-14}) expect_honest(chain, truth, accuracy);
    }
}

// Natural modes turn rounding into 3e-10. Runs of two accuracies differed by 2e-14, which was the estimate.
BOOST_AUTO_TEST_CASE(modes_that_agree_do_not_hide_what_rounding_makes) {
  const auto chain = rattling(211, true);
  const auto truth = test::ExtendedRow(chain).run();
  BOOST_TEST(error(chain, impact::simulate(chain), truth) > 1e-10);
  expect_honest(chain, truth, 1e-10);
}

/// A run by another flow, as far as an estimate looks at it.
struct OtherRun {
  hybrid::Ending ending;
  std::optional<double> estimated_accuracy;
};

BOOST_AUTO_TEST_CASE(a_run_by_another_flow_counts_where_it_is_further_away_than_its_own_error) {
  using hybrid::Ending;
  const auto estimate = [](double difference, const OtherRun& other) {
    return impact::beside_another_flow(
        1e-13, {.accuracy = 1e-14}, flow::Kind::cvode_adams, 1e-12,
        [&](const hybrid::Options& options) {
          BOOST_TEST((options.flow == flow::Kind::cvode_adams));
          BOOST_TEST(options.accuracy == 1e-12);
          return other;
        },
        [&](const OtherRun&) { return difference; });
  };
  BOOST_TEST(estimate(1e-3, {Ending::separated, {}}) == 1e-3);
  BOOST_TEST(estimate(5e-12, {Ending::separated, {}}) == 1e-13);
  BOOST_TEST(estimate(1e-3, {Ending::separated, 1e-2}) == 1e-13);
  BOOST_TEST(estimate(1e-3, {Ending::failed, {}}) == 1e-13);
}

BOOST_AUTO_TEST_CASE(what_cvode_has_followed_alone_has_no_other_flow) {
  impact::ChainImpact run;
  run.flows = {{.name = "ballistic"}, {.name = "cvode-adams"}};
  BOOST_TEST(impact::has_no_other(run, {}));
  BOOST_TEST(!impact::has_no_other(run, {.flow = flow::Kind::cvode_adams}));
  BOOST_TEST((impact::another_flow({.flow = flow::Kind::cvode_adams}) == std::nullopt));
  run.flows.push_back({.name = "taylor"});
  BOOST_TEST(!impact::has_no_other(run, {}));
}
