#define BOOST_TEST_MODULE chains side by side
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/flow/triplet/triplet_lanes.hpp"
#include "mariotte/impact/chain/chain_batch.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/chain/triplet_scene.hpp"
#include "support/allocations.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;
using Chains = std::vector<model::Chain>;
using Impacts = std::vector<impact::BriefImpact>;

namespace {

/// Three Hertz balls of all kinds: masses over three decades, stiffnesses over four, touching or not, moving
/// or at rest.
model::Chain random_triplet(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto decades = [&](double count) { return std::pow(10.0, uniform(-count / 2, count / 2)); };
  const auto one_of = [&](int count) { return std::uniform_int_distribution(1, count)(random) == 1; };
  model::Chain chain;
  for (int i = 0; i < 3; ++i) {
    chain.mass.push_back(decades(3));
    chain.velocity.push_back(one_of(4) ? 0 : uniform(-1, 1));
  }
  for (int j = 0; j < 2; ++j) {
    chain.law.push_back(contact::Hertz{decades(4)});
    chain.gap.push_back(one_of(2) ? 0 : decades(4));
  }
  return chain;
}
Chains random_triplets(int count) {
  std::mt19937_64 random(11);
  Chains chains;
  for (int i = 0; i < count; ++i) chains.push_back(random_triplet(random));
  return chains;
}

/// So far on the way from one to another; gaps may not overlap.
model::Chain between(const model::Chain& from, const model::Chain& to, double share) {
  auto chain = from;
  const auto mix = [&](double a, double b) { return a + share * (b - a); };
  for (std::size_t i = 0; i < 3; ++i) {
    chain.mass[i] = std::exp(mix(std::log(from.mass[i]), std::log(to.mass[i])));
    chain.velocity[i] = mix(from.velocity[i], to.velocity[i]);
  }
  for (std::size_t j = 0; j < 2; ++j) chain.gap[j] = std::max(0.0, mix(from.gap[j], to.gap[j]));
  return chain;
}

/// Stiffness ratio 0.1 to 10, last velocity −1 to 0.
Chains map(int size) {
  Chains chains;
  for (int i = 0; i < size * size; ++i) {
    const double ratio = 0.1 * std::pow(100.0, (i / size) / (size - 1.0)),
                 last = (i % size) / (size - 1.0) - 1;
    chains.push_back(equal_masses({contact::Hertz{1}, contact::Hertz{ratio}}, {1, 0, last}));
  }
  return chains;
}

/// In this order, so many between two calls of `finish`.
Impacts solve(const Chains& chains, double accuracy, const std::vector<Index>& order, Index at_once) {
  Impacts impacts(chains.size());
  impact::ChainBatch batch([&](Index which, const model::Chain& chain, const impact::BriefImpact& impact) {
    BOOST_TEST(chain.velocity == chains[which].velocity, boost::test_tools::per_element());
    impacts[which] = impact;
  });
  for (Index i = 0; i < std::ssize(order); ++i) {
    batch.put(order[i], chains[order[i]], {.accuracy = accuracy});
    if (i % at_once == at_once - 1) batch.finish();
  }
  batch.finish();
  return impacts;
}
std::vector<Index> in_order(std::size_t count) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}
Impacts solve(const Chains& chains, double accuracy) {
  return solve(chains, accuracy, in_order(chains.size()), 1000);
}

bool leaves_lanes(const model::Chain& chain, double accuracy) {
  NaturalRoot natural_root;
  const auto scene = impact::triplet_scene(chain, {.accuracy = accuracy}, natural_root);
  if (!scene) return true;
  auto triplet = impact::dimensionless(*scene, accuracy);
  flow::Triplets().follow({&triplet, 1}, accuracy);
  impact::BriefImpact impact;
  return !impact::describe(*scene, triplet, accuracy, impact);
}

double fastest(const model::Chain& chain) {
  double speed = 0;
  for (const double v : chain.velocity) speed = std::max(speed, std::abs(v));
  return speed;
}

std::vector<Index> periods_of(const impact::ChainImpact& impact) {
  std::vector<Index> periods;
  for (const auto& contact : impact.contacts) periods.push_back(std::ssize(contact.periods));
  return periods;
}

/// Within the accuracy of a run by the general machinery that is far more accurate, with its history; so is
/// what the solver of one chain gives, whose lanes hold the contacts.
void expect_as_in_general(const Chains& chains, double accuracy) {
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
        for (std::size_t j = 0; j < 2; ++j) {
          BOOST_TEST(std::abs(got->impulse[j] - exact.contacts[j].impulse) <= 2 * mass * allowed);
        }
        BOOST_TEST(got->periods == periods_of(general), boost::test_tools::per_element());
        BOOST_TEST(got->events == std::ssize(general.events));
        BOOST_TEST(std::abs(got->time - exact.time) <= 1e3 * accuracy * (1 + exact.time));
      }
    if (alone.periods[0] + alone.periods[1] > 4)
      BOOST_TEST(impacts[i].estimated_accuracy.has_value() == alone.estimated_accuracy.has_value());
  }
}

bool same_bits(const impact::BriefImpact& a, const impact::BriefImpact& b) {
  return a.velocity == b.velocity && a.impulse == b.impulse && a.time == b.time && a.periods == b.periods &&
         a.events == b.events && a.steps == b.steps && a.estimated_accuracy == b.estimated_accuracy;
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_triplets_are_what_they_are_in_general) {
  const auto chains = random_triplets(3000);
  for (const double accuracy : {1e-6, 1e-10}) expect_as_in_general(chains, accuracy);
}

BOOST_AUTO_TEST_CASE(a_map_is_what_it_is_in_general) {
  for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-12}) expect_as_in_general(map(32), accuracy);
}

BOOST_AUTO_TEST_CASE(hardly_a_triplet_of_a_map_is_solved_alone) {
  const auto chains = map(32);
  for (const double accuracy : {1e-6, 1e-10})
    BOOST_TEST(std::count_if(chains.begin(), chains.end(),
                             [&](const auto& chain) { return leaves_lanes(chain, accuracy); }) <= 4);
}

BOOST_AUTO_TEST_CASE(what_a_chain_gives_depends_on_no_other) {
  const auto chains = random_triplets(700);
  auto order = in_order(chains.size());
  const auto impacts = solve(chains, 1e-8, order, 1000);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  for (const Index at_once : {1, 3, 700}) {
    const auto others = solve(chains, 1e-8, order, at_once);
    for (std::size_t i = 0; i < chains.size(); ++i) BOOST_TEST(same_bits(impacts[i], others[i]));
  }
}

BOOST_AUTO_TEST_CASE(it_makes_no_difference_how_stiff_or_heavy_they_are) {
  auto chains = map(8);
  for (auto& chain : chains)
    chain.law[1] = contact::Hertz{std::round(8 * std::get<contact::PowerLaw>(chain.law[1]).stiffness + 1)};
  const auto impacts = solve(chains, 1e-8);
  for (auto& chain : chains) {
    for (double& mass : chain.mass) mass *= 0x1p-40;
    for (double& velocity : chain.velocity) velocity *= 0x1p10;
    for (auto& law : chain.law) std::get<contact::PowerLaw>(law).stiffness *= 3.7e5;
  }
  const auto others = solve(chains, 1e-8);
  for (std::size_t i = 0; i < chains.size(); ++i)
    for (std::size_t ball = 0; ball < 3; ++ball)
      BOOST_TEST(others[i].velocity[ball] == 0x1p10 * impacts[i].velocity[ball]);
}

// Between two triplets whose contacts close a different number of times lies one in which some contact
// grazes.
BOOST_AUTO_TEST_CASE(no_contact_is_missed_that_hardly_closes_or_hardly_opens) {
  const auto chains = random_triplets(400);
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
  BOOST_TEST(near.size() > 2000u);
  const auto impacts = solve(near, 1e-9);
  Index differing = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const auto exact = impact::simulate(near[i], {.accuracy = 1e-12});
    BOOST_TEST(difference(impacts[i].velocity, exact.velocity) <= 1e-9 * fastest(near[i]));
    differing += impacts[i].periods != periods_of(exact);
  }
  BOOST_TEST(differing == 0);
}

BOOST_AUTO_TEST_CASE(others_are_solved_alone) {
  const Chains chains = {
      equal_masses({contact::Hertz{1}, contact::Hertz{1}}, {1, 0, -1}),  // both let go at one instant
      equal_masses({contact::Linear{1}, contact::Hertz{1}}, {1, 0, 0}), equal_chain(5),
      equal_masses(
          {contact::Viscoelastic{.stiffness = 1, .damping = 0.1, .exponent = 1.5}, contact::Hertz{1}},
          {1, 0, 0}),
      [] {
        auto wall = equal_masses({contact::Hertz{1}, contact::Hertz{1}}, {1, 0, 0});
        wall.mass[2] = infinity;
        return wall;
      }()};
  const auto impacts = solve(chains, 1e-8);
  impact::ChainSolver solver;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    BOOST_TEST_CONTEXT(i) BOOST_TEST(leaves_lanes(chains[i], 1e-8));
    BOOST_TEST(same_bits(impacts[i], solver.solve(chains[i], {.accuracy = 1e-8})));
  }
}

BOOST_AUTO_TEST_CASE(a_chain_that_makes_no_sense_harms_no_other) {
  const auto good = map(3);
  auto bad = good.front();
  bad.mass[1] = -1;
  Index taken = 0;
  impact::ChainBatch batch([&](Index, const auto&, const auto&) { ++taken; });
  batch.put(0, good[0], {});
  BOOST_CHECK_THROW(batch.put(1, bad, {}), InvalidParameter);
  BOOST_CHECK_THROW(batch.put(1, good[1], {.accuracy = 2}), InvalidParameter);
  batch.put(2, good[2], {.accuracy = 1e-5});
  batch.finish();
  BOOST_TEST(taken == 2);
}

BOOST_AUTO_TEST_CASE(nothing_is_allocated_after_the_first_of_their_kind) {
  const auto chains = map(20);
  impact::ChainBatch batch([](Index, const auto&, const auto&) {});
  const auto round = [&] {
    for (const auto& chain : chains) batch.put(0, chain, {.accuracy = 1e-8});
    batch.finish();
  };
  round();
  const long before = allocations;
  round();
  BOOST_TEST(allocations == before);
}
