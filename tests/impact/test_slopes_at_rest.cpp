// Slopes by motions along a rigid contact that has none: next to rest any slip rests at once. By hand.
#define BOOST_TEST_MODULE slopes next to rest
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

using namespace mariotte;
using model::Bodies;

namespace {

constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;

model::Body ball(const Vector3& position, const Vector3& velocity) {
  return {.name = "",
          .mass = mass,
          .inertia = {moment, moment, moment},
          .spheres = {{{}, radius}},
          .position = position,
          .velocity = velocity};
}

/// The first ball meets the second head on, from this gap; 0 touches.
Bodies pair(int dimension, double gap, double friction) {
  Bodies bodies{.dimension = dimension, .body = {ball({}, {1, 0, 0}), ball({2 * radius + gap, 0, 0}, {})}};
  bodies.contact = {{.a = {0, 0},
                     .b = {1, 0},
                     .law = contact::Hertz{1e9},
                     .tangential = {model::TangentialLaw::rigid, friction, 0},
                     .touching = gap == 0}};
  return bodies;
}

double slope(const Bodies& bodies, const std::string& outcome, const std::string& parameter) {
  std::vector<impact::Parameter<Bodies>> by;
  for (auto& one : impact::parameters(bodies))
    if (one.name == parameter) by.push_back(one);
  BOOST_TEST_REQUIRE(by.size() == 1u);
  for (const auto& one : impact::sensitivity(bodies, by).outcome)
    if (name_of(one) == outcome) return one.slope[0].value();
  throw std::runtime_error("no outcome " + outcome);
}

}  // namespace

// u = v₁ + r (ω₁ + ω₂) rests by the impulse m u/7: 2/m + 2 r²/I = 7/m.
BOOST_AUTO_TEST_CASE(a_slip_next_to_none_is_taken_away_by_friction) {
  for (const int dimension : {2, 3})
    for (const double gap : {0.0, 1e-3}) {
      const auto bodies = pair(dimension, gap, 0.3);
      const std::string spin = dimension == 2 ? "spin" : "spin[2]";
      BOOST_TEST_CONTEXT(dimension << " dimensions, gap " << gap) {
        const auto tight = boost::test_tools::tolerance(1e-9);
        BOOST_TEST(slope(bodies, "bodies[1]." + spin, "body[0]." + spin) == -2.5 / 7, tight);
        BOOST_TEST(slope(bodies, "bodies[0]." + spin, "body[0]." + spin) == 4.5 / 7, tight);
        if (gap == 0)
          BOOST_TEST(slope(bodies, "bodies[1]." + spin, "body[0].velocity[1]") == -2.5 / 7 / radius, tight);
      }
    }
}

// What has no friction keeps its slip.
BOOST_AUTO_TEST_CASE(a_slip_next_to_none_stays_without_friction) {
  for (const double gap : {0.0, 1e-3})
    BOOST_TEST(std::abs(slope(pair(2, gap, 0), "bodies[1].spin", "body[0].spin")) < 1e-12);
}

// A sphere that rolls off its plane keeps 5/7 of its speed and 2/7 of its spin.
BOOST_AUTO_TEST_CASE(a_microsphere_along_the_normal_is_next_to_rolling) {
  constexpr double size = 2e-6;
  model::Microbody body;
  body.body = model::sphere(size, 1350);
  body.law = {contact::brach_dunn({.stiffness = 1.74e9, .adhesion = 0.1}, size, 1e-3, 1e-3)};
  body.friction = {0.15};
  body.velocity = {-5, 0, 0};
  const auto by = [&](const char* name, Vector3 model::Microbody::*vector, double step) {
    return impact::Parameter<model::Microbody>{name, 0, step, [=](double value, model::Microbody& moved) {
                                                 moved = body;
                                                 (moved.*vector).e3 = value;
                                               }};
  };
  const auto found = impact::sensitivity(
      body, {by("v3", &model::Microbody::velocity, 0.05), by("w3", &model::Microbody::spin, 1e4)});
  const auto slope_of = [&](const std::string& name, std::size_t k) {
    for (const auto& one : found.outcome)
      if (one.name == name) return one.slope[k].value();
    throw std::runtime_error("no outcome " + name);
  };
  const auto tight = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(slope_of("v3", 0) == 5.0 / 7, tight);
  BOOST_TEST(slope_of("w2", 0) * size == -5.0 / 7, tight);
  BOOST_TEST(slope_of("w3", 1) == 2.0 / 7, tight);
  BOOST_TEST(slope_of("v2", 1) / size == 2.0 / 7, tight);
}

namespace {

/// A rod falls on a floor with one end, without slip.
Bodies rod(double friction, double velocity) {
  auto body = ball({0, 0.02, 0}, {velocity, -1, 0});
  body.spheres = {{{-0.02, 0, 0}, radius}, {{0.02, 0, 0}, radius}};
  body.inertia = {moment, 5 * moment, 5 * moment};
  body.angle = 0.3;
  Bodies bodies{.dimension = 2, .body = {body}};
  bodies.plane = {{.name = "", .normal = {0, 1, 0}}};
  bodies.contact = {{.a = {0, -1},
                     .b = {0, 0},
                     .law = contact::Hertz{1e9},
                     .tangential = {model::TangentialLaw::rigid, friction, 0}}};
  return bodies;
}

std::vector<std::string> one_sided(const impact::Sensitivity& slopes) {
  for (const auto& note : slopes.notes)
    if (note.text.starts_with("a contact closes without slip")) return note.parameters;
  return {};
}

}  // namespace

// Against the way it goes friction turns first: one side of the difference is told, and a note names what
// has such slopes.
BOOST_AUTO_TEST_CASE(slopes_of_a_landing_that_slips_from_rest_have_one_side) {
  const auto slopes = impact::sensitivity(rod(0.1, 0), impact::parameters(rod(0.1, 0)));
  BOOST_TEST(one_sided(slopes) == (std::vector<std::string>{"body[0].velocity[0]", "body[0].spin"}),
             boost::test_tools::per_element());
  const auto spin = [](double velocity) {
    return impact::simulate(rod(0.1, velocity), {.accuracy = 1e-13}).body[0].spin.e3;
  };
  const double h = 1e-5, right = (spin(h) - spin(0)) / h, left = (spin(0) - spin(-h)) / h,
               told = slope(rod(0.1, 0), "bodies[0].spin", "body[0].velocity[0]");
  BOOST_TEST(std::abs(right - left) > 0.01 * std::abs(told));
  BOOST_TEST(std::min(std::abs(right - told), std::abs(left - told)) < 1e-3 * std::abs(told));
  const auto held = impact::sensitivity(rod(0.9, 0), impact::parameters(rod(0.9, 0)));
  BOOST_TEST(one_sided(held).empty());
}

BOOST_AUTO_TEST_CASE(slopes_of_a_microrod_that_slips_from_rest_have_one_side) {
  constexpr double size = 2.45e-6;
  model::Microbody body;
  body.body = model::rod(size, 10, 1350);
  body.law = std::vector(2, contact::brach_dunn({.stiffness = 1.74e9, .adhesion = 0.38}, size, 1e-3, 1e-3));
  body.friction = {0.3};
  body.attitude = from_euler({0, 0.7, 0});
  body.velocity = {-0.6737, 0, 0};
  const auto by = [&](const char* name, auto change, double step) {
    return impact::Parameter<model::Microbody>{name, 0, step, [=](double value, model::Microbody& moved) {
                                                 moved = body;
                                                 change(moved, value);
                                               }};
  };
  using model::Microbody;
  const auto slopes = impact::sensitivity(
      body, {by(
                 "spin", [](Microbody& one, double value) { one.spin.e2 = value; }, 10),
             by(
                 "faster", [](Microbody& one, double value) { one.velocity.e1 -= value; }, 1e-3)});
  BOOST_TEST(one_sided(slopes) == std::vector<std::string>{"spin"}, boost::test_tools::per_element());
}

// A sphere that has come to rest rolls on with 5/7 of its velocity and 2/7 of its turn, whatever friction is.
BOOST_AUTO_TEST_CASE(a_microsphere_that_sticks_in_space_has_no_slope_of_its_slip_left) {
  constexpr double size = 2.376023783082572e-06;
  model::Microbody body;
  body.body = model::sphere(size, 6520.755269367542);
  body.law = {contact::brach_dunn({.stiffness = 55837386226.100075, .adhesion = 0.0194035963756924}, size,
                                  2e-3, 2e-3)};
  body.friction = {0.08680415746569703};
  body.velocity = {-7.650247468233224, 1.2206274572280424, 0.5644096808148762};
  body.spin = {0, -21278.766825967392, 0};
  using model::Microbody;
  const auto by = [&](const char* name, auto change, double step) {
    return impact::Parameter<Microbody>{name, 0, step, [=](double value, Microbody& moved) {
                                          moved = body;
                                          change(moved, value);
                                        }};
  };
  const std::vector parameters{
      by(
          "friction", [](Microbody& one, double value) { one.friction.coefficient += value; }, 4e-4),
      by(
          "v2", [](Microbody& one, double value) { one.velocity.e2 += value; }, 5e-3),
      by(
          "w2", [](Microbody& one, double value) { one.spin.e2 += value; }, 100)};
  for (const double accuracy : {1e-6, 1e-9, 1e-12}) {
    const auto slopes = impact::sensitivity(body, parameters, {.accuracy = accuracy});
    const auto expect = [&](const char* name, std::vector<double> known) {
      const auto found = std::ranges::find(slopes.outcome, name, &impact::OutcomeSlopes::name);
      const std::array natural{1.0, 1.0, size};
      for (std::size_t c = 0; c < known.size(); ++c)
        BOOST_TEST(std::abs(*found->slope[c] - known[c]) <= 10 * std::max(accuracy, 1e-11) * natural[c],
                   name << " by " << c << " at " << accuracy << ": " << *found->slope[c]);
    };
    expect("v2", {0, 5.0 / 7, 0});
    expect("v3", {0, 0, -2.0 / 7 * size});
  }
}
