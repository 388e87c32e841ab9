#define BOOST_TEST_MODULE impact_capture_velocity
#include <boost/test/unit_test.hpp>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/microbody/capture_velocity.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// With the published parameters; the damping follows the incident speed [Cheng 2002, eq. 4–5].
impact::BodyAtSpeed published(model::RigidBody shape, const EulerAngles& angles = {}, double friction = 0) {
  return [=](double speed) {
    const double radius = shape.tips[0].radius;
    model::Microbody body;
    body.body = shape;
    const auto law =
        contact::brach_dunn(table_1, radius, contact::hertz_damping(1.5, table_1, radius, density, speed),
                            contact::adhesion_damping(0.5, table_1, radius, density, speed));
    body.law.assign(shape.tips.size(), law);
    body.attitude = from_euler(angles);
    body.velocity = {-speed, 0, 0};
    body.friction = {friction};
    return body;
  };
}

}  // namespace

// Computed in extended precision for the diameters of the paper [Cheng 2002, fig. 7].
BOOST_AUTO_TEST_CASE(spheres_are_captured_below_the_known_speeds) {
  const std::pair<double, double> known[] = {
      {2.58e-6, 2.44599766}, {3.44e-6, 1.81857741}, {4.90e-6, 1.31035940}, {6.89e-6, 0.99740940}};
  for (const auto& [diameter, speed] : known) {
    const auto found = impact::capture_velocity(published(model::sphere(diameter / 2, density)), 5, 1e-9);
    BOOST_REQUIRE(found.has_value());
    BOOST_TEST(std::abs(found->value() - speed) < 1e-8);
    BOOST_TEST(found->captured < found->separated);
    BOOST_TEST(found->separated - found->captured <= 1e-9 * found->value());
    BOOST_TEST(found->runs <= 20);  // halving alone takes 33
  }
}

BOOST_AUTO_TEST_CASE(the_bracket_is_found_from_either_side) {
  const auto sphere = published(model::sphere(2.45e-6, density));
  const auto slow = impact::capture_velocity(sphere, 0.01, 1e-8),
             fast = impact::capture_velocity(sphere, 90, 1e-8);
  BOOST_TEST(std::abs(slow->value() / fast->value() - 1) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_tilted_rod_has_a_capture_velocity_of_its_own) {
  const auto body = published(model::rod(2.45e-6, 10, density), {0, 0.6, 0}, 0.15);
  const auto found = impact::capture_velocity(body, 5, 1e-9);
  BOOST_REQUIRE(found.has_value());
  const auto ending = [&](double share) { return impact::simulate(body(share * found->value())).ending; };
  BOOST_TEST((ending(0.999) == hybrid::Ending::captured));
  BOOST_TEST((ending(1.001) == hybrid::Ending::separated));
}

BOOST_AUTO_TEST_CASE(without_damping_nothing_is_captured) {
  const auto elastic = [](double speed) {
    auto body = published(model::sphere(2.45e-6, density))(speed);
    body.law[0].damping_hertz = body.law[0].damping_adhesion = 0;
    return body;
  };
  BOOST_TEST(!impact::capture_velocity(elastic, 1, 1e-6).has_value());
}

BOOST_AUTO_TEST_CASE(a_run_that_comes_to_no_end_is_an_error) {
  const auto sphere = published(model::sphere(2.45e-6, density));
  BOOST_CHECK_THROW(impact::capture_velocity(sphere, 5, 1e-6, {.max_time = 1e-9}), Error);
}

// Computed in extended precision elsewhere.
BOOST_AUTO_TEST_CASE(a_narrow_bracket_has_the_capture_velocity_in_it) {
  const auto damped = [](double speed) {
    const double radius = 1.4880031887698726e-07, moment = 1.2863058974850697e-31;
    model::Microbody body;
    body.body = {.mass = 1.4523675790961877e-17, .inertia = {moment, moment, moment}, .tips = {{{}, radius}}};
    body.law = {contact::brach_dunn({.stiffness = 9788933536.768856, .adhesion = 1.9514050401936823e-06},
                                    radius, 38.6564047719429, 1344.5202622957852)};
    body.velocity = {-speed, 0, 0};
    return body;
  };
  constexpr double known = 0.010075268435426;
  for (const double tolerance : {1e-9, 1e-12, 1e-15}) {
    const auto found = impact::capture_velocity(damped, 7e-4, tolerance);
    BOOST_TEST_REQUIRE(found.has_value());
    BOOST_TEST(std::abs(found->value() - known) <= std::max(tolerance, 1e-13) * known);
    BOOST_TEST(found->separated - found->captured <= std::max(tolerance, 1e-13) * known);
  }
}
