// What flies away for good does not set the accuracy of what meets.
#define BOOST_TEST_MODULE impact flying apart
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

using namespace mariotte;

namespace {

/// Ball 1 leaves; the others meet at 3 mm/s.
model::Chain chain_left_at(double away) {
  return {.mass = {1, 0.2, 0.15},
          .law = {contact::Hertz{0.1}, contact::Viscoelastic{.stiffness = 0.38, .damping = 0.01}},
          .gap = {0, 0.005},
          .velocity = {away, 0, -0.003}};
}

std::vector<double> pair_alone() {
  auto pair = chain_left_at(0);
  pair.mass.erase(pair.mass.begin());
  pair.law.erase(pair.law.begin());
  pair.gap.erase(pair.gap.begin());
  pair.velocity.erase(pair.velocity.begin());
  return impact::simulate(pair, {.accuracy = 1e-13}).velocity;
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_balls_that_meet_are_as_exact_as_alone) {
  const auto truth = pair_alone();
  for (const double away : {-1e-2, -1.0, -100.0})
    for (const double accuracy : {1e-4, 1e-6, 1e-10}) {
      const auto chain = chain_left_at(away);
      const auto row = impact::simulate(chain, {.accuracy = accuracy}).velocity,
                 network = impact::simulate(model::as_network(chain), {.accuracy = accuracy}).velocity;
      for (const std::size_t i : {0, 1}) {
        BOOST_TEST(std::abs(row[i + 1] - truth[i]) < accuracy * 0.003);
        BOOST_TEST(std::abs(network[i + 1] - truth[i]) < accuracy * 0.003);
      }
    }
}

BOOST_AUTO_TEST_CASE(what_comes_back_counts) {
  auto thrown = chain_left_at(-100);
  BOOST_TEST(model::reference_speed(thrown) < 0.004);
  thrown.gravity = 9.81;
  BOOST_TEST(model::reference_speed(thrown) >= 100);
  auto pulled = chain_left_at(-100);
  pulled.gap[0] = -1e-6;  // still pushes
  pulled.precompressed = true;
  BOOST_TEST(model::reference_speed(pulled) >= 100);
  BOOST_TEST(model::reference_speed(chain_left_at(100)) >= 100);
}
