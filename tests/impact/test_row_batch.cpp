#define BOOST_TEST_MODULE short rows side by side
#include <boost/test/unit_test.hpp>

#include "mariotte/flow/short_row/short_row_lanes.hpp"
#include "support/allocations.hpp"
#include "support/batches.hpp"
#include "support/extended_row.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

constexpr Spread moderate{.masses = 1, .stiffnesses = 2, .gaps = 2};

/// 4 to 9 balls.
Chains random_rows(int count, const Spread& spread = {}) {
  std::mt19937_64 random(5);
  Chains chains;
  for (int i = 0; i < count; ++i) chains.push_back(random_row(random, 4 + i % 6, spread));
  return chains;
}

/// One ball strikes others that touch.
Chains cradles(int count) {
  auto chains = random_rows(count, moderate);
  for (auto& chain : chains) {
    chain.gap.assign(chain.gap.size(), 0);
    chain.velocity.assign(chain.velocity.size(), 0);
    chain.velocity[0] = 1;
  }
  return chains;
}

bool leaves_lanes(const model::Chain& chain, double accuracy) {
  return test::leaves_lanes<9, flow::ShortRows>(chain, accuracy);
}
Index left(const Chains& chains, double accuracy) {
  return std::count_if(chains.begin(), chains.end(),
                       [&](const auto& chain) { return leaves_lanes(chain, accuracy); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_rows_are_what_they_are_in_general) {
  for (const double accuracy : {1e-6, 1e-10}) expect_as_in_general(random_rows(600, moderate), accuracy);
}

BOOST_AUTO_TEST_CASE(cradles_are_what_they_are_in_general) {
  for (const double accuracy : {1e-5, 1e-8, 1e-11}) expect_as_in_general(cradles(300), accuracy);
}

// By an integrator that knows nothing of the library.
BOOST_AUTO_TEST_CASE(rows_are_what_they_are_in_extended_precision) {
  std::mt19937_64 random(9);
  for (const double accuracy : {1e-6, 1e-9, 1e-12}) {
    Chains chains;
    for (int i = 0; i < 120; ++i) {
      chains.push_back(random_row(random, 4 + i % 3, moderate));
      for (double& gap : chains.back().gap) gap = std::max(gap, 0.01);
    }
    const auto impacts = solve(chains, accuracy);
    for (std::size_t i = 0; i < chains.size(); ++i) {
      const auto truth = ExtendedRow(chains[i]).run();
      double error = 0;
      for (std::size_t ball = 0; ball < truth.velocity.size(); ++ball)
        error =
            std::max(error, static_cast<double>(std::abs(impacts[i].velocity[ball] - truth.velocity[ball])));
      BOOST_TEST(error <= accuracy * fastest(chains[i]));
      BOOST_TEST(std::accumulate(impacts[i].periods.begin(), impacts[i].periods.end(), Index(0)) ==
                 truth.periods);
    }
  }
}

BOOST_AUTO_TEST_CASE(equal_balls_part_as_known) {
  for (const auto& c : cases("equal_chains.json")) {
    const int balls = c.at("n");
    if (balls < 4 || balls > 9) continue;
    for (const double accuracy : {1e-6, 1e-10, 1e-13}) {
      BOOST_TEST(!leaves_lanes(equal_chain(balls), accuracy));
      const auto impacts = solve({equal_chain(balls)}, accuracy);
      BOOST_TEST(difference(impacts[0].velocity, c.at("final")) <= std::max(accuracy, 1e-13));
    }
  }
}

BOOST_AUTO_TEST_CASE(it_makes_no_difference_how_stiff_or_heavy_they_are) {
  expect_no_scale(cradles(60), 1e-8);
}

BOOST_AUTO_TEST_CASE(hardly_a_row_is_solved_alone) {
  for (const double accuracy : {1e-6, 1e-10}) {
    BOOST_TEST(left(cradles(300), accuracy) <= 3);
    BOOST_TEST(left(random_rows(600, moderate), accuracy) <= 12);
  }
}

BOOST_AUTO_TEST_CASE(what_a_row_gives_depends_on_no_other) {
  expect_independent(random_rows(700, moderate), 1e-8);
}

BOOST_AUTO_TEST_CASE(no_contact_is_missed_that_hardly_closes_or_hardly_opens) {
  Chains chains;
  std::mt19937_64 random(13);
  for (int i = 0; i < 80; ++i) chains.push_back(random_row(random, 5, moderate));
  const auto near = near_grazes(chains);
  BOOST_TEST(near.size() > 600u);
  expect_none_missed(near);
}

BOOST_AUTO_TEST_CASE(others_are_solved_alone) {
  auto symmetric = equal_chain(4);
  symmetric.velocity = {1, 0, 0, -1};  // two pairs meet, and let go, at one instant
  auto wall = equal_chain(5);
  wall.mass[4] = infinity;
  const Chains chains = {symmetric, wall, equal_chain(10)};
  const auto impacts = solve(chains, 1e-8);
  impact::ChainSolver solver;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    BOOST_TEST_CONTEXT(i) BOOST_TEST(leaves_lanes(chains[i], 1e-8));
    BOOST_TEST(same_bits(impacts[i], solver.solve(chains[i], {.accuracy = 1e-8})));
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_allocated_after_the_first_of_their_sizes) {
  const auto chains = cradles(60);
  impact::ChainBatch batch([](Index, const auto&, const auto&) {});
  const auto round = [&] {
    for (const auto& chain : chains) batch.put(0, chain, {.accuracy = 1e-8});
    batch.finish();
  };
  round();
  round();
  const long before = allocations;
  round();
  BOOST_TEST(allocations == before);
}
