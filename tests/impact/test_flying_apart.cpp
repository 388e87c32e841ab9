// What flies away for good does not set the accuracy of what meets.
#define BOOST_TEST_MODULE impact flying apart
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/model/bodies/bodies_setting.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"
#include "support/struck_balls.hpp"

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

constexpr double slow = 8e-4;

/// Two that meet slowly, and one behind that leaves.
model::Bodies bodies_left_at(double away) {
  auto bodies = test::meeting(test::mindlin);
  for (auto& body : bodies.body) {
    body.velocity = slow * body.velocity;
    body.spin = slow * body.spin;
  }
  bodies.body.push_back(test::ball({-0.05, 0, 0}, {away, 0, 0}));
  bodies.contact.push_back({.a = {0, 0}, .b = {2, 0}, .law = contact::Hertz(1e6)});
  bodies.contact.push_back({.a = {1, 0}, .b = {2, 0}, .law = contact::Hertz(1e6)});
  bodies.named = 3;
  return bodies;
}

double speed_of(const model::Bodies& bodies) {
  return model::setting_of<2>(bodies, 1e-10).speed;
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

BOOST_AUTO_TEST_CASE(two_bodies_that_meet_are_as_exact_as_alone) {
  const auto truth = impact::simulate(bodies_left_at(-1e-3), {.accuracy = 1e-13});
  for (const double away : {-1.0, -100.0})
    for (const double accuracy : {1e-4, 1e-6, 1e-10}) {
      const auto impact = impact::simulate(bodies_left_at(away), {.accuracy = accuracy});
      const double allowed = std::max(accuracy, 1e-15 * -away / slow) * slow;
      for (const std::size_t i : {0, 1}) {
        BOOST_TEST(norm(impact.body[i].velocity - truth.body[i].velocity) < allowed);
        BOOST_TEST(norm(impact.body[i].spin - truth.body[i].spin) * test::radius < allowed);
      }
    }
}

BOOST_AUTO_TEST_CASE(bodies_that_come_back_count) {
  BOOST_TEST(speed_of(bodies_left_at(-100)) < 1.1e-3);
  BOOST_TEST(speed_of(bodies_left_at(100)) >= 100);
  auto thrown = bodies_left_at(-100);
  thrown.gravity = {1, 0, 0};
  BOOST_TEST(speed_of(thrown) >= 100);
  auto swinging = bodies_left_at(-100);
  swinging.body[2].spheres[0].centre = {0.001, 0, 0};
  swinging.body[2].spin.e3 = 1;
  BOOST_TEST(speed_of(swinging) >= 100);
}
