// Chains in batches: random rows, and what of results is compared.
#pragma once
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "mariotte/impact/chain/chain_batch.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/chain/row_scene.hpp"
#include "support/batch_order.hpp"
#include "support/reference.hpp"

namespace mariotte::test {

using Chains = std::vector<model::Chain>;
using Impacts = std::vector<impact::BriefImpact>;

/// How wide random numbers are spread, in decades.
struct Spread {
  double masses = 3, stiffnesses = 4, gaps = 4;
};

/// Hertz balls of all kinds, touching or not, moving or at rest.
inline model::Chain random_row(std::mt19937_64& random, int balls, const Spread& spread = {}) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto decades = [&](double count) { return std::pow(10.0, uniform(-count / 2, count / 2)); };
  const auto one_of = [&](int count) { return std::uniform_int_distribution(1, count)(random) == 1; };
  model::Chain chain;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(decades(spread.masses));
    chain.velocity.push_back(one_of(4) ? 0 : uniform(-1, 1));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.law.push_back(contact::Hertz{decades(spread.stiffnesses)});
    chain.gap.push_back(one_of(2) ? 0 : decades(spread.gaps));
  }
  return chain;
}

/// So far on the way from one to another of the same number of balls; gaps may not overlap.
inline model::Chain between(const model::Chain& from, const model::Chain& to, double share) {
  auto chain = from;
  const auto mix = [&](double a, double b) { return a + share * (b - a); };
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    chain.mass[i] = std::exp(mix(std::log(from.mass[i]), std::log(to.mass[i])));
    chain.velocity[i] = mix(from.velocity[i], to.velocity[i]);
  }
  for (std::size_t j = 0; j < chain.gap.size(); ++j)
    chain.gap[j] = std::max(0.0, mix(from.gap[j], to.gap[j]));
  return chain;
}

/// In this order, so many between two calls of `finish`.
inline Impacts solve(const Chains& chains, double accuracy, const std::vector<Index>& order, Index at_once) {
  Impacts impacts(chains.size());
  impact::ChainBatch batch([&](Index which, const model::Chain& chain, const impact::BriefImpact& impact) {
    BOOST_TEST(chain.velocity == chains[which].velocity, boost::test_tools::per_element());
    impacts[which] = impact;
  });
  put_all(batch, chains, accuracy, order, at_once);
  return impacts;
}
inline Impacts solve(const Chains& chains, double accuracy) {
  return solve(chains, accuracy, in_order(chains.size()), 1000);
}

inline double fastest(const model::Chain& chain) {
  double speed = 0;
  for (const double v : chain.velocity) speed = std::max(speed, std::abs(v));
  return speed;
}

inline std::vector<Index> periods_of(const impact::ChainImpact& impact) {
  std::vector<Index> periods;
  for (const auto& contact : impact.contacts) periods.push_back(std::ssize(contact.periods));
  return periods;
}

/// Within the accuracy of a run by the general machinery that is far more accurate, with its history; so is
/// what the solver of one chain gives.
inline void expect_as_in_general(const Chains& chains, double accuracy) {
  impact::ChainSolver solver;
  const auto impacts = solve(chains, accuracy);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const auto general = impact::simulate(chains[i], {.accuracy = accuracy}),
               exact = impact::simulate(chains[i], {.accuracy = 1e-3 * accuracy});
    const auto& alone = solver.solve(chains[i], {.accuracy = accuracy});
    const double allowed = accuracy * fastest(chains[i]);
    const double mass = *std::max_element(chains[i].mass.begin(), chains[i].mass.end());
    for (const auto* got : {&impacts[i], &alone}) BOOST_TEST_CONTEXT("chain " << i << " at " << accuracy) {
        BOOST_TEST((got->ending == general.ending));
        BOOST_TEST(difference(got->velocity, exact.velocity) <= allowed);
        for (std::size_t j = 0; j < exact.contacts.size(); ++j) {
          BOOST_TEST(std::abs(got->impulse[j] - exact.contacts[j].impulse) <= 2 * mass * allowed);
        }
        BOOST_TEST(got->periods == periods_of(general), boost::test_tools::per_element());
        BOOST_TEST(got->events == std::ssize(general.events));
        BOOST_TEST(std::abs(got->time - exact.time) <= 1e3 * accuracy * (1 + exact.time));
      }
  }
}

/// Whether a row of at most so many balls, followed as one of `Rows`, has to be solved alone.
template <int most, class Rows>
bool leaves_lanes(const model::Chain& chain, double accuracy) {
  NaturalRoot natural_root;
  const auto scene = impact::row_scene<most>(chain, {.accuracy = accuracy}, natural_root);
  if (!scene) return true;
  auto row = impact::dimensionless(*scene, accuracy);
  Rows().follow({&row, 1}, accuracy);
  impact::BriefImpact impact;
  return !impact::describe(*scene, row, accuracy, impact);
}

inline bool same_bits(const impact::BriefImpact& a, const impact::BriefImpact& b) {
  return a.velocity == b.velocity && a.impulse == b.impulse && a.time == b.time && a.periods == b.periods &&
         a.events == b.events && a.steps == b.steps && a.estimated_accuracy == b.estimated_accuracy;
}

/// Nothing depends on who is put in before, or how many at once.
inline void expect_independent(const Chains& chains, double accuracy) {
  auto order = in_order(chains.size());
  const auto impacts = solve(chains, accuracy, order, 1000);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  for (const Index at_once : {1, 3, 700}) {
    const auto others = solve(chains, accuracy, order, at_once);
    for (std::size_t i = 0; i < chains.size(); ++i) BOOST_TEST(same_bits(impacts[i], others[i]));
  }
}

/// Hertz balls that touch, whatever their units: stiffnesses are rounded, so that ratios are exact.
inline void expect_no_scale(Chains chains, double accuracy) {
  const auto stiffness = [](contact::Law& law) -> double& {
    return std::get<contact::PowerLaw>(law).stiffness;
  };
  for (auto& chain : chains)
    for (auto& law : chain.law) stiffness(law) = std::round(8 * stiffness(law) + 1);
  const auto impacts = solve(chains, accuracy);
  for (auto& chain : chains) {
    for (double& mass : chain.mass) mass *= 0x1p-40;
    for (double& velocity : chain.velocity) velocity *= 0x1p10;
    for (auto& law : chain.law) stiffness(law) *= 3.7e5;
  }
  const auto others = solve(chains, accuracy);
  for (std::size_t i = 0; i < chains.size(); ++i)
    for (std::size_t ball = 0; ball < chains[i].mass.size(); ++ball)
      BOOST_TEST(others[i].velocity[ball] == 0x1p10 * impacts[i].velocity[ball]);
}

/// Between two chains whose contacts close a different number of times lies one in which some contact grazes:
/// chains on both sides of it.
inline Chains near_grazes(const Chains& chains) {
  Chains near;
  for (std::size_t i = 0; i + 1 < chains.size(); ++i) {
    const auto periods = [&](double share) {
      return periods_of(impact::simulate(between(chains[i], chains[i + 1], share), {.accuracy = 1e-12}));
    };
    const auto first = periods(0);
    if (first == periods(1)) continue;
    double same = 0, other = 1;
    while (other - same > 1e-7)
      (periods(0.5 * (same + other)) == first ? same : other) = 0.5 * (same + other);
    for (const double apart : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
      for (const double share : {same - apart, other + apart})
        near.push_back(between(chains[i], chains[i + 1], share));
  }
  return near;
}
inline void expect_none_missed(const Chains& near) {
  const auto impacts = solve(near, 1e-9);
  Index differing = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const auto exact = impact::simulate(near[i], {.accuracy = 1e-12});
    BOOST_TEST(difference(impacts[i].velocity, exact.velocity) <= 1e-9 * fastest(near[i]));
    differing += impacts[i].periods != periods_of(exact);
  }
  BOOST_TEST(differing == 0);
}

}  // namespace mariotte::test
