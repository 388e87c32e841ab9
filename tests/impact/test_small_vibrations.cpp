// What is pressed and in balance vibrates as its stiffness says, to the accuracy relative to the vibration.
#define BOOST_TEST_MODULE small vibrations
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "mariotte/contact/stated_law.hpp"
#include "mariotte/contact/thornton.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

using namespace mariotte;

namespace {

constexpr double speed = 3e-7, duration = 40;

/// A ball of mass 1 on Hertz contacts, each pressed to δ = 1 by a force of 1, where ∂f/∂δ = 3/2.
model::Chain ball_between_walls() {
  return {.mass = {infinity, 1, infinity},
          .law = {contact::Hertz(1), contact::Hertz(1)},
          .gap = {-1, -1},
          .velocity = {0, speed, 0},
          .precompressed = true};
}

model::Chain ball_on_a_wall(double force) {
  return {.mass = {infinity, 1},
          .law = {contact::Hertz(1)},
          .gap = {-1},
          .velocity = {0, speed},
          .precompressed = true,
          .drive = {{.direction = {{1, 1.0}},
                     .quantity = model::Driven::force,
                     .signal = model::straight_lines({{0, -force}, {1, -force}})}}};
}

/// Error relative to the speed of the vibration.
double error(double velocity, double stiffness) {
  return std::abs(velocity / speed - std::cos(std::sqrt(stiffness) * duration));
}

hybrid::Options options(double accuracy, std::optional<flow::Kind> flow = {}) {
  return {.accuracy = accuracy, .max_time = duration, .flow = flow};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_pressed_ball_vibrates_to_the_accuracy_asked_for) {
  const auto found = [](double accuracy, flow::Kind flow) {
    return error(impact::simulate(ball_between_walls(), options(accuracy, flow)).velocity[1], 3);
  };
  for (const double accuracy : {1e-5, 1e-6, 1e-8}) BOOST_TEST(found(accuracy, flow::Kind::taylor) < accuracy);
  for (const double accuracy : {1e-5, 1e-6}) BOOST_TEST(found(accuracy, flow::Kind::cvode_adams) < accuracy);
}

// A contact on one side alone has an overtone, relative to the vibration as that is to the indentation.
BOOST_AUTO_TEST_CASE(forces_and_networks_are_held_in_balance_too) {
  for (const double accuracy : {1e-5, 1e-6, 1e-8}) {
    const auto held = impact::simulate(ball_on_a_wall(1), options(accuracy));
    BOOST_TEST(error(held.velocity[1], 1.5) < accuracy + 0.2 * speed);
    const auto network = model::as_network(ball_between_walls());
    BOOST_TEST(error(impact::simulate(network, options(accuracy)).velocity[1], 3) < accuracy);
  }
}

// Without the force the ball is let go, and what it gets back is what counts. A row at rest should stay so.
BOOST_AUTO_TEST_CASE(only_what_is_in_balance_and_moves_asks_for_more_digits) {
  const auto refinement = [](const model::Chain& chain) {
    model::DimensionlessChain scaled;
    make_dimensionless(chain, 1e-8, scaled);
    return scaled.scale.refinement;
  };
  BOOST_TEST(refinement(ball_on_a_wall(0)) == 1);
  BOOST_TEST(refinement(ball_on_a_wall(0.5)) == 1);
  auto row = ball_between_walls();
  row.velocity[1] = 1e-3;
  BOOST_TEST(refinement(row) == 1e-3 / std::sqrt(1.6), boost::test_tools::tolerance(1e-6));
  row.velocity[1] = 0;
  BOOST_TEST(refinement(row) == 1e-9);
}

// A contact that its load has made yield is as stiff as it is then.
BOOST_AUTO_TEST_CASE(what_yields_under_its_load_is_in_balance_too) {
  auto row = ball_between_walls();
  row.law[0] = contact::state(contact::Thornton(1, 1, 0.3));
  row.gap[0] = -contact::static_indentation(row.law[0], 1);
  const auto velocity = [&](double accuracy) { return impact::simulate(row, options(accuracy)).velocity[1]; };
  const double exact = velocity(1e-9);
  for (const double accuracy : {1e-4, 1e-6})
    BOOST_TEST(std::abs(velocity(accuracy) - exact) < accuracy * speed);
}

// Digits that a vibration cannot have beside what it is pressed by.
BOOST_AUTO_TEST_CASE(rounding_of_indentations_is_in_the_estimate) {
  const auto coarse = impact::simulate(ball_between_walls(), options(1e-6)),
             fine = impact::simulate(ball_between_walls(), options(1e-12));
  BOOST_TEST(coarse.estimated_accuracy.value_or(0) < 1e-6);
  BOOST_TEST(fine.estimated_accuracy.value_or(0) > 1e-9);
  BOOST_TEST(error(fine.velocity[1], 3) < fine.estimated_accuracy.value_or(0));
}

// CVODE keeps the indentation itself, which rounds at every step, not how far it is from balance.
BOOST_AUTO_TEST_CASE(steps_of_cvode_round_indentations_each) {
  auto row = ball_between_walls();
  for (const double slow : {1e-6, 1e-9})
    for (const auto flow : {flow::Kind::taylor, flow::Kind::cvode_adams, flow::Kind::cvode_bdf_dense}) {
      row.velocity[1] = slow;
      const auto found = impact::simulate(row, options(1e-10, flow));
      const double error = std::abs(found.velocity[1] / slow - std::cos(std::sqrt(3) * duration));
      BOOST_TEST(error < found.estimated_accuracy.value_or(0));
      BOOST_TEST(found.estimated_accuracy.value_or(0) <
                 (flow == flow::Kind::taylor ? 20 : 1e5) * 1e-15 / slow);
    }
}

// Columns of dampers on a wall, each contact as deep as what stands on it presses it: velocities are
// rounding, and no estimate says that they are wrong.
BOOST_AUTO_TEST_CASE(what_rests_has_no_error) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
  };
  for (int i = 0; i < 40; ++i) {
    model::Chain column{.mass = {infinity},
                        .law = {},
                        .gap = {},
                        .velocity = {0},
                        .gravity = between(0.1, 10),
                        .precompressed = true};
    const int balls = 1 + i % 4;
    for (int j = 0; j < balls; ++j) column.mass.push_back(between(0.01, 1));
    column.velocity.assign(column.mass.size(), 0);
    for (auto ball = column.mass.begin() + 1; ball != column.mass.end(); ++ball) {
      const double weight = std::accumulate(ball, column.mass.end(), 0.0) * column.gravity;
      const contact::Viscoelastic law{
          .stiffness = between(1e3, 1e6), .damping = between(0.01, 10), .exponent = i % 2 == 0 ? 1 : 1.5};
      column.gap.push_back(-std::pow(weight / law.stiffness, 1 / law.exponent));
      column.law.push_back(law);
    }
    for (const double accuracy : {1e-6, 1e-10}) {
      const auto run = impact::simulate(column, {.accuracy = accuracy, .max_time = 0.4});
      for (const double velocity : run.velocity) BOOST_TEST(std::abs(velocity) < 1e-13);
      BOOST_TEST(run.estimated_accuracy.value_or(0) <= accuracy);
    }
  }
  auto held = ball_between_walls();
  held.velocity[1] = 0;
  BOOST_TEST(impact::simulate(model::as_network(held), options(1e-10)).estimated_accuracy.value_or(0) <=
             1e-10);
}
