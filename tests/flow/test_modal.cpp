#define BOOST_TEST_MODULE modal flow
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/flow/wave.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;
using flow::Mode;
using flow::Wave;

namespace {

/// Chains of linear springs only: 3 to 8 balls, masses over 2 decades, stiffnesses over 6, half of the
/// contacts apart.
model::Chain random_springs(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const int balls = std::uniform_int_distribution(3, 8)(random);
  model::Chain chain;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(std::pow(10, uniform(-1, 1)));
    chain.velocity.push_back(uniform(-1, 1));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(uniform(0, 1) < 0.5 ? 0 : uniform(0, 1));
    chain.law.push_back(contact::Linear{std::pow(10, uniform(-3, 3))});
  }
  return chain;
}

/// Closed form of the triplet struck by its first ball [Acary 2003, appendix B, corrected], contact 1 opening
/// first.
Numbers triplet_velocities(double ratio) {
  const double s = std::sqrt(ratio * ratio - ratio + 1), fast = std::sqrt(ratio + 1 + s),
               slow = std::sqrt(3 * ratio) / fast;
  const double gamma = ratio < 1 ? ratio - 1 - s : -ratio / (ratio - 1 + s), beta = -ratio / gamma;
  const auto x1 = [&](double t) {
    return (beta * std::sin(slow * t) / slow - gamma * std::sin(fast * t) / fast) / (2 * s);
  };
  double low = 1, high = 4;
  for (int i = 0; i < 200; ++i) (x1(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  const auto swing = [&](double w) {
    const double half = std::sin(0.5 * w * low);
    return 2 * half * half / (w * w);
  };
  const double X = (std::sin(slow * low) / slow - std::sin(fast * low) / fast) / (2 * s);
  const double D = (std::cos(slow * low) - std::cos(fast * low)) / (2 * s);
  const double W = std::sqrt(2 * ratio), angle = std::atan2(X * W, -D);
  const double p1 = (beta * swing(slow) - gamma * swing(fast)) / (2 * s);
  const double p2 = ratio * ((swing(slow) - swing(fast)) / (2 * s) + X * std::sin(angle) / W +
                             D * (1 - std::cos(angle)) / (W * W));
  return {1 - p1, p1 - p2, p2};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_first_root_of_a_wave_is_found_however_short_its_visit) {
  // 1 − depth − cos t falls below zero for 2√(2 depth) only, once per turn.
  for (const double depth : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    const std::vector<Mode> modes = {{1, 1, std::acos(-1.0) / 2}};
    const Wave wave{1 - depth, 0, {-1}};
    const auto root = flow::first_fall(wave, modes, 0.5, 30);
    BOOST_REQUIRE(root.has_value());
    BOOST_TEST(std::abs(*root - (2 * std::acos(-1.0) - std::acos(1 - depth))) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(a_wave_that_only_comes_near_zero_has_no_root) {
  for (const double distance : {1e-1, 1e-4, 1e-8, 1e-12}) {
    const std::vector<Mode> modes = {{1, 1, 0.3}, {1e-3, 977, 0}};
    BOOST_TEST(!flow::first_fall({1 + 1e-3 + distance, 0, {1, 1}}, modes, 0, 300).has_value());
  }
}

BOOST_AUTO_TEST_CASE(the_earliest_of_many_roots_is_found) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 300; ++i) {
    std::vector<Mode> modes;
    for (int k = 0; k < 4; ++k)
      modes.push_back({uniform(random), std::pow(10, 2 * uniform(random)), 6 * uniform(random)});
    const Wave wave{1, -0.05 * uniform(random), {1, -1, 0.5, 0.3}};
    if (wave.at(modes, 0) <= 0) continue;
    const double end = 20;
    std::optional<double> sampled;
    double last = wave.at(modes, 0);
    for (int k = 1; k <= 200000 && !sampled; ++k) {
      const double value = wave.at(modes, end * k / 200000);
      if (last > 0 && value <= 0) sampled = end * k / 200000;
      last = value;
    }
    const auto root = flow::first_fall(wave, modes, 0, end);
    if (sampled) BOOST_REQUIRE(root.has_value());
    if (!root) continue;
    BOOST_TEST(std::abs(wave.at(modes, *root)) < 1e-12);
    if (sampled) BOOST_TEST(*root <= *sampled);
  }
}

BOOST_AUTO_TEST_CASE(triplets_agree_with_their_closed_form_at_any_stiffness_ratio) {
  // Where contact 1 opens first: ω₂/ω₁ below 2, and beyond for ratios below 1 always.
  for (const double ratio : {1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.9, 1.0, 1.5, 2.0, 2.2}) {
    const auto impact =
        impact::simulate(equal_masses({contact::Linear{1}, contact::Linear{ratio}}, {1, 0, 0}));
    BOOST_TEST_CONTEXT("ratio " << ratio)
    BOOST_TEST(difference(impact.velocity, triplet_velocities(ratio)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(all_linear_references_are_met_to_1e_minus_14) {
  for (const auto& c : cases("linear_triplets.json")) BOOST_TEST_CONTEXT("kappa " << c.at("kappa")) {
      const auto impact = impact::simulate(linear_triplet(c));
      BOOST_TEST(difference(impact.velocity, c.at("final")) < 1e-14);
      // The end of a stiff last contact hangs on a velocity difference that is small itself.
      const double close = c.at("kappa") > 1e4 ? 1e-10 : 1e-13;
      BOOST_TEST(impact.time == c.at("time").get<double>(), boost::test_tools::tolerance(close));
    }
  for (const auto& c : cases("triplets.json")) {
    if (c.at("law") != "linear") continue;
    BOOST_TEST_CONTEXT("kappa " << c.at("kappa") << " velocity " << c.at("velocity")) {
      const auto impact = impact::simulate(triplet(c));
      BOOST_TEST(difference(impact.velocity, c.at("final")) < 2e-14);
      BOOST_TEST(impact.contacts[0].periods.size() == c.at("periods")[0].size());
      BOOST_TEST(impact.contacts[1].periods.size() == c.at("periods")[1].size());
    }
  }
}

BOOST_AUTO_TEST_CASE(stiffness_ratios_up_to_1e10_stay_exact) {
  // In the limit the last two balls are one of mass 2 while in contact, then the stiff contact has a last
  // word; energy and momentum leave one number to check, and the mirrored chain must agree on it.
  for (const double ratio : {1e7, 1e8, 1e9, 1e10}) {
    const contact::Linear soft{1}, stiff{ratio};
    const auto impact = impact::simulate(equal_masses({soft, stiff}, {1, 0, 0}));
    auto mirrored = impact::simulate(equal_masses({stiff, soft}, {0, 0, -1})).velocity;
    std::reverse(mirrored.begin(), mirrored.end());
    for (double& v : mirrored) v = -v;
    BOOST_TEST_CONTEXT("ratio " << ratio) {
      BOOST_TEST(difference(impact.velocity, mirrored) < 1e-12);
      BOOST_TEST(std::abs(impact.velocity[0] + 1.0 / 3) < 2 / std::sqrt(ratio));
      BOOST_TEST(std::abs(impact.energy.residual) < 1e-12);
      BOOST_TEST(std::abs(impact.momentum.residual) < 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(random_springs_are_followed_as_cvode_follows_them) {
  std::mt19937_64 random(1738);
  for (int i = 0; i < 100; ++i) {
    const auto chain = random_springs(random);
    const auto exact = impact::simulate(chain);
    const auto cvode = impact::simulate(chain, {.accuracy = 1e-9, .flow = "cvode-adams"});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST(std::abs(exact.energy.residual) < 1e-12 * exact.energy.initial);
      BOOST_TEST(period_counts(exact) == period_counts(cvode), boost::test_tools::per_element());
      if (difference(exact.velocity, cvode.velocity) > 1e-8)
        BOOST_TEST(difference(exact.velocity, cvode.velocity) <=
                   100 * impact::estimate_accuracy(chain, {.accuracy = 1e-9, .flow = "cvode-adams"}, cvode));
      for (std::size_t j = 0; j < exact.contacts.size(); ++j)
        BOOST_TEST(std::abs(exact.contacts[j].peak_force - cvode.contacts[j].peak_force) <=
                   1e-5 * (1e-3 + cvode.contacts[j].peak_force));
    }
  }
}
