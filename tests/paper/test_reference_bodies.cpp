// Microbodies against reference cases in extended precision, at accuracy 1e-9.
#define BOOST_TEST_MODULE paper_reference_bodies
#include <boost/test/unit_test.hpp>

#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

const hybrid::Options to_1e9{.accuracy = 1e-9};

/// Ten times the accuracy asked for, relative to the incident speed; spins as velocities of the tip.
constexpr double allowed = 1e-8;

void check_motion(const impact::MicrobodyImpact& impact, const nlohmann::json& c, double tolerance) {
  const auto body = microbody(c);
  const auto& final = c.at("final");
  const double speed = speed_scale(body), length = body.body.tips[0].radius;
  BOOST_TEST(norm(impact.final.velocity - vector_of(final, 4)) < tolerance * speed);
  BOOST_TEST(length * norm(impact.final.spin - vector_of(final, 11)) < tolerance * speed);
  BOOST_TEST(norm(impact.final.position - vector_of(final, 1)) < tolerance * length);
  const Vector3 turn{final.at(8), final.at(9), final.at(10)};
  const auto& q = impact.final.attitude;
  BOOST_TEST(norm(Vector3{q.x, q.y, q.z} - turn) < tolerance);
  BOOST_TEST(std::abs(impact.final.time - final.at(0).get<double>()) < tolerance * impact.final.time);
  BOOST_TEST(std::abs(impact.restitution.tip - c.at("restitution").at(0).get<double>()) < tolerance);
  BOOST_TEST(std::abs(impact.restitution.centre - c.at("restitution").at(1).get<double>()) < tolerance);
}

void check_events(const impact::MicrobodyImpact& impact, const nlohmann::json& c, double tolerance) {
  const auto found = lasting(events_of(impact)), expected = lasting(events_of(c));
  BOOST_TEST(text(found) == text(expected));
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
    BOOST_TEST(std::abs(found[i].time - expected[i].time) < tolerance * impact.final.time);
}

/// Energy is lost, never made, and the balance closes.
void check_energy(const impact::MicrobodyImpact& impact) {
  const auto& e = impact.energy;
  BOOST_TEST(e.hertz_damping >= 0);
  BOOST_TEST(e.adhesion_damping >= 0);
  BOOST_TEST(e.friction >= 0);
  BOOST_TEST(std::abs(e.residual) < allowed * e.initial);
}

void check(const std::string& file) {
  for (const auto& c : body_cases(file)) {
    const nlohmann::json named = c.value("angles", nlohmann::json());
    BOOST_TEST_CONTEXT(c.at("shape") << " " << c.at("velocity") << " angles " << named << " ratio "
                                     << c.value("length_ratio", 0.0) << " friction " << c.at("friction")) {
      const auto impact = impact::simulate(microbody(c), to_1e9);
      BOOST_TEST(hybrid::name(impact.ending) == c.at("ending").get<std::string>());
      check_events(impact, c, allowed);
      check_energy(impact);
      if (c.contains("final")) check_motion(impact, c, allowed);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(spheres_rebound_or_are_captured_as_their_speed_says) {
  check("sphere_normal.json");
}

BOOST_AUTO_TEST_CASE(oblique_and_spinning_spheres_slide_and_stick) {
  check("sphere_oblique.json");
}

BOOST_AUTO_TEST_CASE(dumbbells_of_every_length) {
  check("dumbbell_length.json");
}

BOOST_AUTO_TEST_CASE(rods_of_every_length) {
  check("rod_length.json");
}

BOOST_AUTO_TEST_CASE(rods_at_every_tilt) {
  check("rod_tilt.json");
}

BOOST_AUTO_TEST_CASE(slip_and_stick_happen_when_they_should) {
  check("rod_events.json");
}

BOOST_AUTO_TEST_CASE(bodies_that_move_in_all_directions) {
  check("spatial.json");
}

BOOST_AUTO_TEST_CASE(the_other_tip_strikes_second) {
  check("secondary.json");
}

// Spot values of the corrected model [Cheng 2002, fig. 7 and 10].
BOOST_AUTO_TEST_CASE(restitution_follows_from_the_published_parameters) {
  const double radius = 2.45e-6, speed = 5;
  model::Microbody body;
  body.body = model::sphere(radius, density);
  body.velocity = {-speed, 0, 0};
  const auto law =
      contact::brach_dunn(table_1, radius, contact::hertz_damping(1.5, table_1, radius, density, speed),
                          contact::adhesion_damping(0.5, table_1, radius, density, speed));
  body.law = {law};
  BOOST_TEST(std::abs(impact::simulate(body, to_1e9).restitution.tip - 0.866282538126) < 1e-9);
  body.body = model::rod(radius, 10, density);
  body.law = {law, law};
  body.attitude = from_euler({0, 42 * std::numbers::pi / 180, 0});
  body.friction = {0.15};
  const auto e = impact::simulate(body, to_1e9).restitution;
  BOOST_TEST(std::abs(e.tip - 0.9456351428) < 1e-9);
  BOOST_TEST(std::abs(e.centre - 0.0674207118) < 1e-9);
  BOOST_TEST(std::abs(contact::rest_indentation(law) - 34.63e-9) < 0.01e-9);
}
