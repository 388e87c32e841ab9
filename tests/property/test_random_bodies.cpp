#define BOOST_TEST_MODULE property_random_bodies
#include "support/body_properties.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

Vector3 turned(const Vector3& v, double angle) {
  return rotate(rotation(normal_axis, angle), v);
}

double difference(const model::Microbody& body, const Vector3& velocity, const Vector3& spin,
                  const impact::MicrobodyImpact& other) {
  return std::max(norm(velocity - other.final.velocity), reach(body) * norm(spin - other.final.spin)) /
         speed_scale(body);
}

}  // namespace

BOOST_AUTO_TEST_CASE(kinetic_energy_never_grows_in_a_first_impact) {
  check_many(1000, 20021, 1);
}

BOOST_AUTO_TEST_CASE(kinetic_energy_never_grows_over_many_impacts) {
  check_many(200, 20022, 6);
}

// The well of adhesion makes these up to ten thousand times faster than they came: what is asked for of the
// incident speed is less than a rounding error then.
BOOST_AUTO_TEST_CASE(slow_tips_in_space_come_to_an_end_at_any_accuracy) {
  std::mt19937 random(20025);
  std::uniform_real_distribution<double> decades(-4, -1);
  for (int i = 0; i < 100; ++i) {
    auto body = random_body(random);
    const double slower = std::pow(10, decades(random));
    body.velocity = slower * body.velocity;
    body.spin = slower * body.spin;
    for (const double accuracy : {1e-12, 1e-13}) {
      const auto impact = impact::simulate(body, {.accuracy = accuracy});
      BOOST_TEST((impact.ending == hybrid::Ending::separated || impact.ending == hybrid::Ending::captured),
                 "scene " << i << ": " << hybrid::name(impact.ending) << " " << impact.message);
    }
  }
}

// In a plane friction is the sign of a slip; CVODE sees its end a little late.
BOOST_AUTO_TEST_CASE(friction_gives_no_energy_whatever_the_flow) {
  std::mt19937 random(20026);
  std::uniform_real_distribution<double> decades(-2, 0), tilt(0, 1.5);
  for (int i = 0; i < 60; ++i) {
    auto body = random_body(random);
    const double slower = std::pow(10, decades(random));
    body.attitude = from_euler({0, tilt(random), 0});
    body.velocity = slower * Vector3{body.velocity.e1, 0, body.velocity.e3};
    body.spin = {};
    if (model::tip_below_plane(body)) continue;
    for (const auto* flow : {"auto", "cvode-adams", "cvode-bdf-dense"})
      BOOST_TEST_CONTEXT("scene " << i << " by " << flow) {
        check_passivity(body, {.accuracy = 1e-8, .flow = flow::parse_kind(flow)});
      }
  }
}

// Friction may hold the slip of this one near zero while its direction turns: too stiff for series. Whether
// it does depends on the last digits, at about one accuracy in six.
BOOST_AUTO_TEST_CASE(a_slip_that_creeps_in_space_is_followed_to_its_end) {
  std::mt19937 random(2003);
  model::Microbody body;
  for (int i = 0; i < 330; ++i) body = random_body(random);
  body.impacts = 20;
  int stiff = 0;
  for (double accuracy = 1e-7; accuracy > 1e-10; accuracy *= 0.85) {
    check_passivity(body, {.accuracy = accuracy});
    const auto flows = impact::simulate(body, {.accuracy = accuracy}).flows;
    stiff +=
        std::any_of(flows.begin(), flows.end(), [](const auto& use) { return use.name == "cvode-bdf-klu"; });
  }
  BOOST_TEST(stiff > 0);
}

BOOST_AUTO_TEST_CASE(a_rotation_of_everything_about_the_normal_changes_nothing) {
  std::mt19937 random(20023);
  for (int i = 0; i < 200; ++i) {
    const auto body = random_body(random);
    auto other = body;
    const double angle = 0.1 + 0.03 * i;
    other.attitude = rotation(normal_axis, angle) * body.attitude;
    other.velocity = turned(body.velocity, angle);
    other.spin = turned(body.spin, angle);
    const auto one = impact::simulate(body, {.accuracy = 1e-9}),
               two = impact::simulate(other, {.accuracy = 1e-9});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST((one.ending == two.ending));
      if (one.ending == hybrid::Ending::separated)
        BOOST_TEST(difference(body, turned(one.final.velocity, angle), turned(one.final.spin, angle), two) <
                   1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_sphere_has_no_frame_of_its_own) {
  std::mt19937 random(20024);
  std::uniform_real_distribution<double> any(-3, 3);
  for (const auto& c : body_cases("sphere_oblique.json")) {
    const auto body = microbody(c);
    auto other = body;
    other.attitude = from_euler({any(random), any(random), any(random)});
    const auto one = impact::simulate(body, {.accuracy = 1e-9}),
               two = impact::simulate(other, {.accuracy = 1e-9});
    BOOST_TEST(difference(body, one.final.velocity, one.final.spin, two) < 1e-9);
  }
}
