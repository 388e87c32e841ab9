// Bodies on their way to contacts: what meets, what it costs in digits, and which contacts are told.
#define BOOST_TEST_MODULE impact bodies flight
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "support/struck_balls.hpp"

using namespace mariotte;
using namespace mariotte::test;

BOOST_AUTO_TEST_CASE(bodies_that_nothing_can_touch_fly_on) {
  model::Bodies bodies{.dimension = 2};
  bodies.body = {ball({0, 0, 0}, {1, 0.5, 0}, {0, 0, 3})};
  const auto impact = impact::simulate(bodies);
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_TEST(impact.body[0].velocity.e1 == 1);
  BOOST_TEST(impact.energy.residual == 0);
}

/// Their flight has no closed form. It ends where spheres that hold them are apart for ever.
BOOST_AUTO_TEST_CASE(bodies_without_an_axis_end_where_they_have_flown_apart) {
  model::Body block{.mass = 0.01, .inertia = {1e-7, 2e-7, 2.5e-7}, .position = {0, 0, 0.02}};
  block.velocity = {0, 0, -1};
  block.spin = {10, 20, 30};
  block.spheres = {{{0.004, 0.005, -0.009}, 0.001}, {{-0.004, -0.005, -0.009}, 0.001}};
  model::Bodies bodies{.dimension = 3, .body = {block}, .plane = {{.normal = {0, 0, 1}}}};
  for (Index tip = 0; tip < 2; ++tip)
    bodies.contact.push_back(
        {.a = {0, -1}, .b = {0, tip}, .law = contact::Hertz(1e9), .tangential = mindlin});
  const auto impact = impact::simulate(bodies);
  BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
  BOOST_TEST(impact.time > 0.009);
  BOOST_TEST(impact.time < 0.1);
  BOOST_TEST(impact.body[0].velocity.e3 > 0);
  BOOST_TEST(impact.body[0].position.e3 > 0.0105);
  bodies.gravity = {0, 0, -9.81};
  BOOST_TEST((impact::simulate(bodies, {.max_time = 0.3}).ending == hybrid::Ending::time_limit));
  bodies.gravity = bodies.body[0].velocity = bodies.body[0].spin = {};
  for (const double height : {0.01, 0.0101}) {  // at rest on the plane and above it
    bodies.body[0].position.e3 = height;
    const auto still = impact::simulate(bodies);
    BOOST_TEST((still.ending == hybrid::Ending::separated), still.message);
    BOOST_TEST(still.time == 0);
  }
}

/// What is left of equal velocities is no approach: two balls would meet after 10¹³ s.
BOOST_AUTO_TEST_CASE(bodies_that_drift_by_rounding_do_not_meet) {
  for (const int dimension : {2, 3}) {
    model::Bodies bodies{.dimension = dimension};
    bodies.body = {ball({0, 0, 0}, {}), ball({0.021, 0, 0}, {-1e-16, 0, 0}), ball({0, 0.05, 0}, {0, 1, 0})};
    for (const auto& [a, b] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}})
      bodies.contact.push_back({.a = {a, 0}, .b = {b, 0}, .law = contact::Hertz(1e6), .tangential = mindlin});
    const auto impact = impact::simulate(bodies);
    BOOST_CHECK(impact.ending == hybrid::Ending::separated);
    BOOST_TEST(impact.events.empty());
    BOOST_TEST(impact.time == 0);
  }
}

/// As long as something else is to come, they do: at 10 s, before the third ball is there.
BOOST_AUTO_TEST_CASE(bodies_that_drift_meet_before_another_one_comes) {
  for (const int dimension : {2, 3}) {
    model::Bodies bodies{.dimension = dimension};
    bodies.body = {ball({0, 0, 0}, {}), ball({2 * radius + 1e-7, 0, 0}, {-1e-8, 0, 0}),
                   ball({-20, 0, 0}, {1, 0, 0})};
    for (const auto& [a, b] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}})
      bodies.contact.push_back({.a = {a, 0}, .b = {b, 0}, .law = contact::Hertz(1e9), .tangential = mindlin});
    const auto impact = impact::simulate(bodies, {.accuracy = 1e-6});
    BOOST_CHECK(impact.ending == hybrid::Ending::separated);
    BOOST_TEST_REQUIRE(!impact.contacts[0].periods.empty());
    BOOST_TEST(std::abs(impact.contacts[0].periods[0].start - 10) < 1e-3);
    const auto other = impact::simulate(bodies, {.accuracy = 1e-6, .flow = flow::Kind::cvode_adams});
    for (int i = 0; i < 3; ++i) BOOST_TEST(norm(impact.body[i].velocity - other.body[i].velocity) < 2e-6);
    BOOST_TEST(std::abs(impact.energy.residual) < 1e-6 * impact.energy.initial);
  }
}

BOOST_AUTO_TEST_CASE(few_pairs_keep_their_numbers_in_results) {
  model::Bodies bodies{.dimension = 2};
  for (int i = 0; i < 22; ++i) bodies.body.push_back(ball({0.03 * i, 0, 0}, {i == 20 ? 1.0 : 0.0, 0, 0}));
  for (Index a = 0; a < 4; ++a)
    bodies.contact.push_back({.a = {a, 0}, .b = {a + 1, 0}, .law = contact::Hertz(1e6)});
  bodies.contact.push_back({.a = {20, 0}, .b = {21, 0}, .law = contact::Hertz(1e6)});
  const auto few = impact::simulate(bodies);
  BOOST_TEST_REQUIRE(few.contacts.size() == 5u);
  for (Index j = 0; j < 5; ++j) BOOST_TEST(few.contacts[j].contact == j);
  BOOST_TEST(few.events.front().of(model::BodyEvent::close).front() == 4);
  for (Index a = 0; a < 20; ++a)
    for (Index b = a + 2; b < 22; ++b)
      bodies.contact.push_back({.a = {a, 0}, .b = {b, 0}, .law = contact::Hertz(1e6)});
  BOOST_TEST(bodies.contact.size() > 200u);
  bodies.named = 1;
  const auto many = impact::simulate(bodies);
  BOOST_TEST_REQUIRE(many.contacts.size() == 2u);
  BOOST_TEST(many.contacts[1].contact == 4);
  BOOST_TEST(many.events.front().of(model::BodyEvent::close).front() == 1);
}

BOOST_AUTO_TEST_CASE(what_is_slow_and_far_away_says_how_many_digits_are_left) {
  const auto far = [](double gap, double speed) {
    auto bodies = strike(0.5, mindlin);
    bodies.contact[0].touching = false;
    bodies.body[0].position.e2 = radius + gap;
    bodies.body[0].velocity = speed * bodies.body[0].velocity;
    return bodies;
  };
  hybrid::Options options;
  options.accuracy = 1e-9;
  const auto near = impact::simulate(far(0, 1e-9), options);
  BOOST_TEST(!near.estimated_accuracy.has_value());
  for (const auto kind : {std::optional<flow::Kind>(), std::optional(flow::Kind::cvode_adams)}) {
    options.flow = kind;
    const auto impact = impact::simulate(far(1e-4, 1e-9), options);
    BOOST_TEST_REQUIRE(impact.estimated_accuracy.has_value());
    BOOST_TEST(*impact.estimated_accuracy > options.accuracy);
    const double apart = norm(impact.body[0].velocity - near.body[0].velocity);
    BOOST_TEST(apart < *impact.estimated_accuracy * 1e-9);
  }
  BOOST_CHECK_THROW(impact::simulate(far(1, 1e-10), options), Error);
}

// A ball is released a metre above a plane, and followed for ten nanoseconds of its fall.
BOOST_AUTO_TEST_CASE(gaps_that_no_body_crosses_in_time_cost_no_digits) {
  auto bodies = strike(0, {});
  bodies.contact[0].touching = false;
  bodies.body[0].position.e2 = 1;
  bodies.body[0].velocity = {};
  bodies.gravity = {0, -9.81, 0};
  const auto impact = impact::simulate(bodies, {.accuracy = 1e-10, .max_time = 1e-8, .flies_on = true});
  BOOST_TEST((impact.ending == hybrid::Ending::time_limit), impact.message);
  BOOST_TEST(!impact.estimated_accuracy.has_value());
  check_near(impact.body[0].velocity.e2, -9.81e-8, 1e-20);
}

// A damped ball starts on a plane that it does not press yet. What is left of its vibration in the end is
// rounding.
BOOST_AUTO_TEST_CASE(what_settles_is_compared_with_the_speeds_of_its_vibration) {
  auto bodies = strike(0, {}, contact::PowerLaw{.stiffness = 1e6, .damping = 100, .exponent = 1});
  bodies.body[0].velocity = {};
  bodies.gravity = {0, -9.81, 0};
  const hybrid::Options options{.accuracy = 1e-10, .max_time = 0.05};
  const auto impact = impact::simulate(bodies, options);
  check_near(impact.body[0].velocity.e2, 0, 1e-16);
  check_near(impact.contacts[0].peak_force, 1.4772228 * mass * 9.81, 1e-6);  // with ζ = 0.27524
  BOOST_TEST(impact.estimated_accuracy.value_or(0) < 1e-12);
  BOOST_TEST(impact::estimate_accuracy(bodies, options, impact) < 1e-12);
}
