// Pairs of balls within reach of each other, against all pairs.
#define BOOST_TEST_MODULE near pairs
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/model/network/network.hpp"

using namespace mariotte;

namespace {

std::vector<model::Ball> scattered(int count, int dimension, double from, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<model::Ball> balls;
  for (int i = 0; i < count; ++i) {
    auto& ball = balls.emplace_back(model::Ball{{}, {}, 1, 0.02 + 0.1 * unit(random)});
    for (int k = 0; k < dimension; ++k) {
      ball.position.push_back(from + unit(random));
      ball.velocity.push_back(0);
    }
  }
  return balls;
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_pairs_within_reach_are_found_in_order) {
  std::mt19937_64 random(9);
  for (const int dimension : {2, 3})
    for (const double from : {0.0, 1e6})
      for (const double reach : {0.0, 0.05, infinity}) {
        const auto balls = scattered(60, dimension, from, random);
        const auto pairs = model::near_pairs(balls, reach);
        auto next = pairs.begin();
        Index found = 0, beyond = 0;
        for (Index i = 0; i < 60; ++i)
          for (Index j = i + 1; j < 60; ++j) {
            const bool is_next = next != pairs.end() && next->left == i && next->right == j;
            const double gap = model::ball_contact(balls, i, j).gap;
            if (gap <= reach) BOOST_TEST(is_next);
            found += gap <= reach;
            beyond += is_next && gap > reach;
            next += is_next;
          }
        BOOST_TEST((next == pairs.end()));
        BOOST_TEST(found > 5);
        BOOST_TEST(beyond == 0);
      }
}

BOOST_AUTO_TEST_CASE(balls_that_touch_far_away_are_a_pair) {
  const std::vector<model::Ball> balls = {{{1e6, 0.1}, {0, 0}, 1, 0.05}, {{1e6 + 0.1, 0.1}, {0, 0}, 1, 0.05}};
  BOOST_TEST(model::near_pairs(balls, 0).size() == 1U);
  BOOST_TEST(model::ball_contact(balls, 0, 1).gap == 0);
}
