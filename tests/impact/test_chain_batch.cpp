#define BOOST_TEST_MODULE chains side by side
#include <boost/test/unit_test.hpp>

#include "mariotte/core/error.hpp"
#include "mariotte/flow/triplet/triplet_lanes.hpp"
#include "support/allocations.hpp"
#include "support/batches.hpp"

using namespace mariotte;
using namespace mariotte::test;
namespace {

/// Masses over three decades, stiffnesses over four.
Chains random_triplets(int count) {
  std::mt19937_64 random(11);
  Chains chains;
  for (int i = 0; i < count; ++i) chains.push_back(random_row(random, 3));
  return chains;
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

bool leaves_lanes(const model::Chain& chain, double accuracy) {
  return test::leaves_lanes<3, flow::Triplets>(chain, accuracy);
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
  expect_independent(random_triplets(700), 1e-8);
}

BOOST_AUTO_TEST_CASE(it_makes_no_difference_how_stiff_or_heavy_they_are) {
  expect_no_scale(map(8), 1e-8);
}

BOOST_AUTO_TEST_CASE(no_contact_is_missed_that_hardly_closes_or_hardly_opens) {
  const auto near = near_grazes(random_triplets(400));
  BOOST_TEST(near.size() > 2000u);
  expect_none_missed(near);
}

BOOST_AUTO_TEST_CASE(those_run_again_say_how_far_they_were_apart) {
  const auto chains = random_triplets(3000);
  const auto impacts = solve(chains, 1e-8);
  impact::ChainSolver solver;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const auto& alone = solver.solve(chains[i], {.accuracy = 1e-8});
    if (alone.periods[0] + alone.periods[1] > 4)
      BOOST_TEST(impacts[i].estimated_accuracy.has_value() == alone.estimated_accuracy.has_value());
  }
}

BOOST_AUTO_TEST_CASE(others_are_solved_alone) {
  const Chains chains = {
      equal_masses({contact::Hertz{1}, contact::Hertz{1}}, {1, 0, -1}),  // both let go at one instant
      equal_masses({contact::Linear{1}, contact::Hertz{1}}, {1, 0, 0}),
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
