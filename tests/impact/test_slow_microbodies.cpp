// Microbodies that creep, swing and slip end alike at every accuracy and by every flow.
#define BOOST_TEST_MODULE impact_slow_microbodies
#include <boost/test/unit_test.hpp>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// A body as a scene file says it, with its own surface.
struct Slim {
  model::RigidBody body;
  double adhesion, zeta_hertz, zeta_adhesion, friction;
  Vector3 velocity;
  EulerAngles angles = {};
  Index impacts = 1;
  double stiffness = 1.74e9;
};

model::Microbody slim(const Slim& s) {
  const double radius = s.body.tips[0].radius, speed = -s.velocity.e1;
  const contact::Surface surface{.stiffness = s.stiffness, .adhesion = s.adhesion};
  model::Microbody body;
  body.body = s.body;
  body.law.assign(s.body.tips.size(),
                  contact::brach_dunn(
                      surface, radius, contact::hertz_damping(s.zeta_hertz, surface, radius, density, speed),
                      contact::adhesion_damping(s.zeta_adhesion, surface, radius, density, speed)));
  body.friction = {s.friction};
  body.velocity = s.velocity;
  body.attitude = from_euler(s.angles);
  body.impacts = s.impacts;
  return body;
}

/// Every accuracy gives the ending, and velocity and spin to 10 × that accuracy, of one that is far tighter.
void expect_same_at_every_accuracy(const model::Microbody& body) {
  const auto best = impact::simulate(body, {.accuracy = 1e-12});
  for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
    const auto one = impact::simulate(body, {.accuracy = accuracy, .max_events = 100});
    const double allowed = 10 * accuracy * speed_scale(body);
    BOOST_TEST((one.ending == best.ending), hybrid::name(one.ending));
    BOOST_TEST(norm(one.final.velocity - best.final.velocity) < allowed);
    BOOST_TEST(reach(body) * norm(one.final.spin - best.final.spin) < allowed);
    BOOST_TEST(std::abs(one.energy.residual) < 10 * accuracy * one.energy.initial);
  }
}

}  // namespace

// Their tips creep to their places in the wells while the rest swings on: below and above the barrier.
BOOST_AUTO_TEST_CASE(a_body_that_swings_about_a_held_tip_is_captured_at_one_instant) {
  expect_same_at_every_accuracy(slim({.body = model::dumbbell(3.015e-6, 8.4, density),
                                      .adhesion = 0.223,
                                      .zeta_hertz = 173,
                                      .zeta_adhesion = 0.357,
                                      .friction = 1.394,
                                      .velocity = {-0.95, 0.3456, -0.1595},
                                      .angles = {-0.444, 0.0742, -0.4685}}));
  expect_same_at_every_accuracy(slim({.body = model::rod(8.95e-6, 2.42, density),
                                      .adhesion = 0.4507,
                                      .zeta_hertz = 116,
                                      .zeta_adhesion = 0.216,
                                      .friction = 0.874,
                                      .velocity = {-2.22, -1.81, 1.99}}));
}

// Its tip will be slow for long enough by so little that errors of forces at 1e-6 could choose the instant.
BOOST_AUTO_TEST_CASE(errors_of_forces_do_not_choose_when_a_swinging_body_rests) {
  expect_same_at_every_accuracy(
      slim({.body = model::dumbbell(1.67617955567821e-06, 9.9995133887837895, density),
            .adhesion = 0.051325318741818393,
            .zeta_hertz = 36.518386840465539,
            .zeta_adhesion = 6.4567979662362056,
            .friction = 0.855402710496314,
            .velocity = {-18.439979771947957, -6.2595681695350338, 14.733268500523298},
            .angles = {2.4195000275759604, 0.76454889947572191, -0.2283076020917103}}));
}

// Its tip turns so near to rest that a loose run cannot tell, and swings on.
BOOST_AUTO_TEST_CASE(a_tip_that_turns_near_its_rest_is_not_captured_there) {
  expect_same_at_every_accuracy(
      slim({.body = model::dumbbell(1.6681125182212139e-05, 4.8045155837129361, density),
            .adhesion = 0.013534844028454453,
            .zeta_hertz = 1.9026281438204289,
            .zeta_adhesion = 0.61662872615140807,
            .friction = 0.25249955959100256,
            .velocity = {-0.8731077688485146, 0.70127110546016158, 0.52004911908571849},
            .angles = {-0.37333207810655811, -0.49841848969985048, 1.0263573471600536},
            .stiffness = 204064059019.32285}));
}

// What is left of its slip is rounding, and no flow can follow the direction of that.
// It turns at the depth of its strongest damping, and would creep out 50 times as fast as its rest speed: so
// friction goes on there.
BOOST_AUTO_TEST_CASE(a_strongly_damped_sphere_is_not_captured_where_it_turns) {
  auto sphere = slim({.body = model::sphere(6.5113829154617922e-06, density),
                      .adhesion = 0.099141767213746984,
                      .zeta_hertz = 180.47867496935339,
                      .zeta_adhesion = 5.1152162240236621,
                      .friction = 0.10541847988405839,
                      .velocity = {-2.094691679475146, -2.0121050460282763, 0}});
  sphere.spin = {0, 0, -504496.48036567675};
  expect_same_at_every_accuracy(sphere);
}

// Just after the onset the pull of a big sphere is overcome, and the step behind that event is a long one: as
// at the onset, four of five coefficients are hardly more than zero.
BOOST_AUTO_TEST_CASE(a_step_that_begins_next_to_the_onset_is_as_accurate_as_one_that_begins_there) {
  expect_same_at_every_accuracy(slim({.body = model::sphere(0.0074771296855076896, density),
                                      .adhesion = 0.010537732158245496,
                                      .zeta_hertz = 0,
                                      .zeta_adhesion = 0,
                                      .friction = 0.37075408225542733,
                                      .velocity = {-31.731955783521453, 0, 0},
                                      .stiffness = 175844925360.82153}));
}

BOOST_AUTO_TEST_CASE(a_slip_in_space_ends_at_the_tightest_accuracy) {
  auto body = slim({.body = model::rod(5.7319498137839691e-07, 9.1217537469615859, density),
                    .adhesion = 0.050495413634744524,
                    .zeta_hertz = 0.033475974372125572,
                    .zeta_adhesion = 0,
                    .friction = 0.72224715445153687,
                    .velocity = {-4.2415595913232389, -2.60758897362214, -0.092961843536194771},
                    .angles = {-2.2298294019963896, 0.50150756888081993, -0.98738339492180938},
                    .stiffness = 41349269.913260639});
  body.spin = {584174.8176009435, 94212.252665925582, 244849.84416290463};
  expect_same_at_every_accuracy(body);
}

// It leaves with what is left of the much larger speed that adhesion gives it on the way.
BOOST_AUTO_TEST_CASE(a_body_slow_beside_its_well_keeps_the_accuracy_of_its_own_speed) {
  expect_same_at_every_accuracy(
      slim({.body = model::dumbbell(7.4296784776215512e-07, 4.3401203734169886, density),
            .adhesion = 0.077148752602239745,
            .zeta_hertz = 0,
            .zeta_adhesion = 0,
            .friction = 1.3353836821231293,
            .velocity = {-0.0040139120431435674, -0.002112007693256584, -0.00044537537742232882}}));
}

// A tip that turns where its forces balance rests at its turn, which is a small part of a step.
BOOST_AUTO_TEST_CASE(rest_at_a_turn_is_not_stepped_over) {
  auto body = slim({.body = model::dumbbell(2.0533968653449297e-06, 1.4339153642017615, density),
                    .adhesion = 0.37441537681534826,
                    .zeta_hertz = 83.56790316993559,
                    .zeta_adhesion = 2.7722640695572469,
                    .friction = 0,
                    .velocity = {-0.49132481578508502, -0.19817104218699952, -0.38248995794100843},
                    .angles = {-0.10315386961883499, 0.12559363189563499, 0.40211073776783257}});
  body.spin = {44862.51284761179, -24062.184957801946, 59019.698833809431};
  expect_same_at_every_accuracy(body);
}

// A tip is slow enough to rest for a tenth of a step, and then moves on.
BOOST_AUTO_TEST_CASE(rest_within_a_step_is_not_stepped_over) {
  expect_same_at_every_accuracy(
      slim({.body = model::rod(1.7065939816452595e-06, 10.471530648404062, density),
            .adhesion = 0.15889914924229098,
            .zeta_hertz = 270.49762148434712,
            .zeta_adhesion = 4.4763386831491534,
            .friction = 0.17994849058474938,
            .velocity = {-0.54161886001767479, 0.032053692277907511, 0.083221076876952182}}));
}

// Errors of hundreds of steps add up: such a body is run again, tighter. At 1e-10 both runs are as tight as
// series of creeping contacts get: they are the same, and masses off by rounding tell.
BOOST_AUTO_TEST_CASE(a_body_that_creeps_for_long_keeps_the_accuracy) {
  const auto body = slim({.body = model::rod(3.6808646114047367e-06, 2.982692676681479, density),
                          .adhesion = 0.018294160076615221,
                          .zeta_hertz = 213.81302816889749,
                          .zeta_adhesion = 0.57262229367070128,
                          .friction = 0.83639633145734282,
                          .velocity = {-1.1169815952117299, 0, 0},
                          .angles = {0, 1.4895031498246203, 0}});
  expect_same_at_every_accuracy(body);
  const auto impact = impact::simulate(body, {.accuracy = 1e-9});
  BOOST_TEST_REQUIRE(impact.estimated_accuracy.has_value());
  BOOST_TEST(*impact.estimated_accuracy <= 1e-9);
  BOOST_TEST(impact.requested_accuracy == 1e-9);
  const auto tight = impact::simulate(body, {.accuracy = 1e-10});
  BOOST_TEST(tight.estimated_accuracy.value() < 1e-10);
}

// Friction turns with the sign of a load that is small against errors of the damper.
BOOST_AUTO_TEST_CASE(the_load_of_a_swinging_tip_has_its_sign_at_every_accuracy) {
  expect_same_at_every_accuracy(
      slim({.body = model::rod(8.7709946084198576e-06, 0.012078563342707405, density),
            .adhesion = 0.042182253022616523,
            .zeta_hertz = 265.38533613699218,
            .zeta_adhesion = 0.1352263894653952,
            .friction = 0.28792214052119885,
            .velocity = {-0.65111086067767754, 0, 0.22085894436591791},
            .angles = {0, -0.44816329440691183, 0}}));
}

// BDF follows it, and Newton's iteration must not hold the slip back; nor may its rounding turn friction.
BOOST_AUTO_TEST_CASE(a_slip_from_rest_in_space_is_the_same_by_every_flow) {
  auto body = slim({.body = model::dumbbell(4.2592313357303934e-08, 0.67770015764791269, density),
                    .adhesion = 0.31751477543042739,
                    .zeta_hertz = 0.62135597285630828,
                    .zeta_adhesion = 0.60870209482518112,
                    .friction = 1.3780851662902269,
                    .velocity = {-23.157719695251323, 7.5435022656994288, 21.208732188347224},
                    .angles = {-1.4103509920950743, -0.62596965762770795, -0.10573973494872746},
                    .stiffness = 65851243.385304771});
  body.lever = model::Lever::indented;
  body.spin = {-52600475.665207647, 185221437.42619517, 178034061.90399238};
  expect_same_at_every_accuracy(body);
  const auto one = impact::simulate(body, {.accuracy = 1e-10});
  const auto other = impact::simulate(body, {.accuracy = 1e-10, .flow = flow::Kind::cvode_adams});
  BOOST_TEST(norm(one.final.velocity - other.final.velocity) < 1e-10 * speed_scale(body));
}

// The body turns by 10⁵ rad between its impacts: no double tells how it lands.
BOOST_AUTO_TEST_CASE(what_a_long_flight_leaves_unknown_is_said) {
  auto body = slim({.body = model::rod(7.9477801023200848e-06, 5.3717834559908191, density),
                    .adhesion = 0.14736814254956154,
                    .zeta_hertz = 1.473311960857862,
                    .zeta_adhesion = 0.98345642026830105,
                    .friction = 0,
                    .velocity = {-4.834495157991487, 0, 0},
                    .angles = {0, -0.35669555031374811, 0},
                    .impacts = 4});
  body.gravity = 9.81;
  const auto impact = impact::simulate(body, {.accuracy = 1e-8});
  BOOST_TEST_REQUIRE(impact.estimated_accuracy.has_value());
  BOOST_TEST(*impact.estimated_accuracy > 1e-4);
}

// Where the well is deep and the body slow, its energy is below the barrier when the tip turns, at its
// deepest.
BOOST_AUTO_TEST_CASE(a_tip_that_turns_while_its_slip_begins_is_not_at_rest) {
  auto body = slim({.body = model::rod(6.0951015618278753e-07, 5.4467875703660837, density),
                    .adhesion = 0.060556865192160365,
                    .zeta_hertz = 1.6681694830854539,
                    .zeta_adhesion = 0.65266634662284817,
                    .friction = 0.33944164791977749,
                    .velocity = {-0.14490304507805846, -0.062465194716222305, 0.0037454898720059499},
                    .angles = {-1.066064301367974, -0.31106194670174281, 0.54866017032893355}});
  body.spin = {17788.293424705167, -4694.0883352247574, -25369.564763130129};
  expect_same_at_every_accuracy(body);
}

// Two tips at different heights of a turning body cannot both stick, however little the heights differ.
BOOST_AUTO_TEST_CASE(tips_of_nearly_flat_bodies_hold_and_slip_alike_at_every_accuracy) {
  expect_same_at_every_accuracy(slim({.body = model::dumbbell(1.332e-6, 2.65, density),
                                      .adhesion = 0.0522,
                                      .zeta_hertz = 1.39,
                                      .zeta_adhesion = 0,
                                      .friction = 0.726,
                                      .velocity = {-0.47388, 0, 0.06756},
                                      .angles = {0, 1.57078, 0},
                                      .impacts = 3}));
  auto turning = slim({.body = model::rod(8.736e-6, 1.9135, density),
                       .adhesion = 0.0564,
                       .zeta_hertz = 1.654,
                       .zeta_adhesion = 0.1616,
                       .friction = 0.4554,
                       .velocity = {-23.945, 0, 0},
                       .angles = {0, 1.5470749, 0},
                       .impacts = 2});
  turning.spin = {0, 906681.2473, 0};
  expect_same_at_every_accuracy(turning);
}
