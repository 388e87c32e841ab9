// Bodies that come to rest on a floor under gravity, and stay there.
#define BOOST_TEST_MODULE impact_bodies_at_rest
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "support/flow_steps.hpp"

using namespace mariotte;

namespace {

constexpr double mass = 0.038, half = 0.008, gravity = 9.81, speed = 0.9, height = 0.02;

/// The lower edge of a block, dropped onto stiff springs with dampers four times critical. At rest they are
/// pressed in by 3·10⁻¹³ m, of which 10⁻⁵ is rounding of where the block is.
model::Bodies dropped_block() {
  const double moment = mass * (4 * half * half + 1e-4) / 12;
  const model::Body block{.name = "",
                          .mass = mass,
                          .inertia = {moment, moment, moment},
                          .spheres = {{{-half, -0.005, 0}, 0}, {{half, -0.005, 0}, 0}},
                          .position = {0, 0.005 + height, 0},
                          .attitude = {},
                          .angle = 0.05,
                          .velocity = {-0.2, -speed, 0},
                          .spin = {}};
  model::Bodies bodies{.dimension = 2};
  bodies.body = {block};
  bodies.plane = {{.name = "", .point = {}, .normal = {0, 1, 0}, .velocity = {}}};
  for (const Index corner : {0, 1})
    bodies.contact.push_back({.a = {0, -1},
                              .b = {0, corner},
                              .law = contact::Viscoelastic{6e11, 1.26e6, 1},
                              .tangential = {},
                              .share = 1});
  bodies.gravity = {0, -gravity, 0};
  bodies.named = 1;
  return bodies;
}

}  // namespace

/// BDF would take 10⁶ steps, as short as a decay, if it had to resolve what rounding makes of the rates.
BOOST_AUTO_TEST_CASE(strong_dampers_at_rest_take_few_steps) {
  const double end = 0.08;
  for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
    const auto impact = impact::simulate(dropped_block(), {.accuracy = accuracy, .max_time = end});
    BOOST_TEST((impact.ending == hybrid::Ending::time_limit), impact.message);
    const auto steps = test::steps(impact);
    BOOST_TEST_MESSAGE(steps << " steps at " << accuracy);
    BOOST_TEST(steps < 20'000);
    BOOST_TEST(std::abs(impact.body[0].velocity.e2) < 1e-12);
    BOOST_TEST(std::abs(impact.body[0].angle) < 1e-9);
    const double pressed = impact.contacts[0].normal_impulse + impact.contacts[1].normal_impulse;
    BOOST_TEST(pressed == mass * (speed + gravity * end), boost::test_tools::tolerance(accuracy));
  }
}
