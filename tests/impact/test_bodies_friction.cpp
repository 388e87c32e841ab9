// Tips that stick, slip and reverse together: the mode after an event is the one that motion follows,
// whatever rounding says. Numbers are those of integrations with small steps and smoothed friction elsewhere.
#define BOOST_TEST_MODULE impact bodies friction
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/named_laws.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"

using namespace mariotte;
using hybrid::Ending;
using model::BodyEvent;
using model::TangentialLaw;

namespace {

/// A body with two tips of one radius above a floor, in the plane.
model::Bodies above_floor(const model::Body& body, double length, double radius, const contact::Law& law,
                          const model::Tangential& tangential, double share) {
  model::Bodies bodies{.dimension = 2, .body = {body}, .plane = {{.normal = {0, 1, 0}}}};
  bodies.body[0].spheres = {{{-length / 2, 0, 0}, radius}, {{length / 2, 0, 0}, radius}};
  for (Index tip = 0; tip < 2; ++tip)
    bodies.contact.push_back(
        {.a = {0, -1}, .b = {0, tip}, .law = law, .tangential = tangential, .share = share});
  bodies.named = 2;
  return bodies;
}

contact::Law thornton(const contact::LawNumbers& numbers) {
  for (const auto& law : contact::named_laws)
    if (law.name == "thornton") return law.make(numbers);
  throw std::runtime_error("no such law");
}

/// Stiff where it unloads, so that its force is rounded more coarsely than that of other laws.
model::Bodies dented_dumbbell() {
  return above_floor(
      {.mass = 0.6615576435249968,
       .inertia = {0, 0, 0.2103847487207857},
       .position = {0, 0.426725361145281, 0},
       .angle = 0.031761305396814016,
       .velocity = {0.940538410692386, -1.3858131505212845, 0},
       .spin = {0, 0, -1.8441234435153682}},
      1.02540026750493, 0.126725361145281,
      thornton({.effective_modulus = 1e6, .effective_radius = 0.2, .yield_pressure = 10255.823586425668}),
      {TangentialLaw::spring, 0.9726723758108748, 691945.004568087}, 0.5);
}

/// Falls on one tip, then on the other, and turns through where it lies flat while both slip and stick.
model::Bodies falling_rod() {
  auto bodies = above_floor({.mass = 0.8149940075175868,
                             .inertia = {0, 0, 0.19094821095178557},
                             .position = {0.09056985569111997, 1.2, 0},
                             .angle = 2.762801090858116,
                             .velocity = {0.7360761912583977, -2.901032430726567, 0},
                             .spin = {0, 0, 1.0886307159160378}},
                            1.4891920548188042, 0.12751442114017134,
                            std::make_shared<contact::HuntCrossley>(50355.5942261995, 0.4529273331020866),
                            {TangentialLaw::rigid, 0.17020617447974906, 0}, 0.5);
  bodies.gravity = {0, -5.1077425861681975, 0};
  return bodies;
}

/// The same, so that both would stick where it lies flat.
model::Bodies flat_rod() {
  auto bodies = above_floor({.mass = 1.6389819963066425,
                             .inertia = {0, 0, 0.2661536233777518},
                             .position = {0.01565620067835391, 1.2, 0},
                             .angle = 3.8152732566997476,
                             .velocity = {-0.7189718325987158, -1.4026845126903849, 0},
                             .spin = {0, 0, -1.5319256224166196}},
                            1.0339997177313518, 0.22320502939634468,
                            std::make_shared<contact::HuntCrossley>(44465.83732075384, 0.011056115289259611),
                            {TangentialLaw::rigid, 0.9649411370134899, 0}, 0);
  bodies.gravity = {0, -4.81267350986876, 0};
  return bodies;
}

/// With all that it can touch, at another velocity.
model::Bodies boosted(model::Bodies bodies, const Vector3& by) {
  for (auto& body : bodies.body) body.velocity = body.velocity + by;
  for (auto& plane : bodies.plane) plane.velocity = plane.velocity + by;
  return bodies;
}

void check_end(const impact::BodiesImpact& impact, const Vector3& velocity, double spin, double tolerance) {
  BOOST_TEST((impact.ending == Ending::time_limit), impact.message);
  BOOST_TEST(norm(impact.body[0].velocity - velocity) < tolerance);
  BOOST_TEST(std::abs(impact.body[0].spin.e3 - spin) < tolerance);
}

constexpr auto accuracies = {1e-8, 1e-10, 1e-11, 1e-12, 1e-13};
const Vector3 by{1.0062557458155574, -0.611475614763826, 0};

}  // namespace

BOOST_AUTO_TEST_CASE(a_spring_that_begins_to_stick_at_its_cap_goes_on_to_stick) {
  const auto bodies = dented_dumbbell();
  for (const double accuracy : accuracies) BOOST_TEST_CONTEXT(accuracy) {
      const auto impact = impact::simulate(bodies, {.accuracy = accuracy, .max_time = 0.2, .flies_on = true});
      check_end(impact, {-0.149904188, 0.463585087, 0}, 0.244196569, 2e-8);
      for (const auto& event : impact.events)
        BOOST_TEST((event.of(BodyEvent::stick).empty() || event.of(BodyEvent::slip).empty()));
    }
}

BOOST_AUTO_TEST_CASE(a_tip_reverses_the_way_it_is_driven_where_a_rod_is_flat) {
  for (const double accuracy : accuracies) BOOST_TEST_CONTEXT(accuracy) {
      const hybrid::Options options{.accuracy = accuracy, .max_time = 0.33, .flies_on = true};
      const Vector3 velocity{0.0315419700, 1.2922026105, 0};
      const double spin = -0.1592639946;
      check_end(impact::simulate(falling_rod(), options), velocity, spin, 1e-8);
      check_end(impact::simulate(boosted(falling_rod(), by), options), velocity + by, spin, 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(tips_that_cannot_both_stick_have_no_doubt) {
  for (const double accuracy : accuracies) BOOST_TEST_CONTEXT(accuracy) {
      const hybrid::Options options{.accuracy = accuracy, .max_time = 0.45, .flies_on = true};
      const Vector3 velocity{-0.462134868, 2.926145530, 0};
      const double spin = 1.983574488;
      check_end(impact::simulate(flat_rod(), options), velocity, spin, 1e-8);
      check_end(impact::simulate(boosted(flat_rod(), by), options), velocity + by, spin, 1e-8);
    }
}

// Its cap falls to zero in a slip that takes 10⁻¹⁰ of the contact. ξ'' = −ωₜ² ξ with ωₜ² = 7 kₜ/(2 m), but
// for the lever, which is half a percent shorter where the ball is pressed most.
BOOST_AUTO_TEST_CASE(what_a_spring_holds_where_its_contact_ends_is_lost_to_friction) {
  constexpr double mass = 0.01, radius = 0.01, stiffness = 4e6, tangential = 1.6e6, speed = 1;
  model::Bodies bodies{.dimension = 2,
                       .body = {{.mass = mass,
                                 .inertia = {0, 0, 0.4 * mass * radius * radius},
                                 .spheres = {{{}, radius}},
                                 .position = {0, radius, 0},
                                 .velocity = {speed, -1, 0}}},
                       .plane = {{.normal = {0, 1, 0}}}};
  bodies.contact = {{.a = {0, -1}, .b = {0, 0}, .law = contact::Linear{stiffness}}};
  bodies.named = 1;
  const double frequency = std::sqrt(3.5 * tangential / mass),
               time = std::numbers::pi * std::sqrt(mass / stiffness),
               stretch = speed / frequency * std::sin(frequency * time);
  for (const double friction : {1e5, 1e7, 1e9})
    for (const double accuracy : {1e-3, 1e-5, 1e-7}) {
      bodies.contact[0].tangential = {TangentialLaw::spring, friction, tangential};
      const auto impact = impact::simulate(bodies, {.accuracy = accuracy});
      BOOST_TEST((impact.ending == Ending::separated));
      BOOST_TEST(impact.energy.losses.friction == 0.5 * tangential * stretch * stretch,
                 boost::test_tools::tolerance(0.02));
      BOOST_TEST(std::abs(impact.energy.residual) < accuracy * impact.energy.initial);
    }
}

// The corner slips and loses its load at one instant.
BOOST_AUTO_TEST_CASE(what_a_spring_holds_at_its_cap_where_its_load_vanishes_is_lost_to_friction) {
  auto bodies =
      above_floor({.mass = 1, .inertia = {0, 0, 0.1 / 12}, .position = {0, 0.154907906, 0}, .angle = 0.12},
                  0.1, 0, contact::Viscoelastic{.stiffness = 4e5, .damping = 120, .exponent = 1},
                  {TangentialLaw::spring, 1e9, 3.2e5}, 0);
  for (auto& sphere : bodies.body[0].spheres) sphere.centre.e2 = -0.15;
  bodies.gravity = {0, -9.81, 0};
  for (const double accuracy : {1e-4, 1e-6, 1e-8}) {
    const auto impact = impact::simulate(bodies, {.accuracy = accuracy, .max_time = 0.4});
    BOOST_TEST(impact.energy.losses.friction == 1.9301375e-3, boost::test_tools::tolerance(1e-4));
    BOOST_TEST(std::abs(impact.energy.residual) < 1e-5 * impact.energy.work);
  }
}

// Flat on two corners, only the sum of both frictions is determined.
BOOST_AUTO_TEST_CASE(redundant_stick_ends_a_run_by_name_and_keeps_what_was_computed) {
  auto bodies = above_floor({.name = "block",
                             .mass = 1,
                             .inertia = {0, 0, 0.01},
                             .position = {0, 0.2, 0},
                             .velocity = {0, -0.5, 0}},
                            0.2, 0.1, contact::Linear(1e6), {TangentialLaw::rigid, 0.5, 0}, 0.5);
  const auto impact = impact::simulate(bodies);
  BOOST_TEST((impact.ending == Ending::failed));
  BOOST_TEST(
      impact.message.find("redundant at 0.2 s (plane 1–block.1, plane 1–block.2)") != std::string::npos,
      impact.message);
  BOOST_TEST(impact.time == 0.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(impact.body[0].velocity.e2 == -0.5);
  BOOST_TEST_REQUIRE(impact.contacts.size() == 2U);
  for (const auto& contact : impact.contacts) BOOST_TEST(contact.periods.size() == 1U);
}
