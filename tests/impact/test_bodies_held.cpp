// Bodies that friction holds for ever: they jam, or roll on.
#define BOOST_TEST_MODULE impact_bodies_held
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "support/struck_balls.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// A ball thrown into a groove of two planes that is 40° wide, along it at `along`.
model::Bodies groove(double friction, int dimension = 2, double along = 0) {
  const double half = 20 * std::numbers::pi / 180;
  model::Bodies bodies{.dimension = dimension};
  bodies.body = {ball({0, radius / std::sin(half) + 1e-4, 0}, {0.01, -1, along})};
  for (const double side : {1.0, -1.0})
    bodies.plane.push_back(
        {.name = "", .point = {}, .normal = {side * std::cos(half), std::sin(half), 0}, .velocity = {}});
  for (const Index plane : {0, 1})
    bodies.contact.push_back({.a = {plane, -1},
                              .b = {0, 0},
                              .law = contact::Viscoelastic{1e6, 20, 1},
                              .tangential = {model::TangentialLaw::rigid, friction, 0}});
  bodies.named = 2;
  return bodies;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_ball_that_jams_in_a_groove_is_bound) {
  for (const int dimension : {2, 3}) {
    const auto impact = impact::simulate(groove(1, dimension));
    BOOST_TEST((impact.ending == hybrid::Ending::bound), impact.message);
    BOOST_TEST(impact.time < 0.1);
    BOOST_TEST(norm(impact.body[0].velocity) < 1e-10);
    BOOST_TEST(impact.energy.stored > 0.1 * impact.energy.initial);
    const auto later = impact::simulate(groove(1, dimension), {.max_time = 0.04});
    BOOST_TEST((later.ending == hybrid::Ending::time_limit));
    BOOST_TEST(norm(later.body[0].position - impact.body[0].position) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(with_less_friction_it_comes_out_again) {
  for (const int dimension : {2, 3}) {
    const auto impact = impact::simulate(groove(0.1, dimension));
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(impact.body[0].velocity.e2 > 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_ball_that_rolls_on_in_a_groove_is_bound) {
  const auto impact = impact::simulate(groove(1, 3, 0.5));
  BOOST_TEST((impact.ending == hybrid::Ending::bound), impact.message);
  BOOST_TEST(impact.time < 0.1);
  const auto& end = impact.body[0];
  BOOST_TEST(end.velocity.e3 > 0.1);
  BOOST_TEST(std::hypot(end.velocity.e1, end.velocity.e2) < 1e-10);
  BOOST_TEST(std::abs(end.spin.e3) < 1e-8);
}
