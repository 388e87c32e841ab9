// Bodies with friction: closed forms, invariances, balances.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/struck_balls.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

double slip_after(const impact::BodiesImpact& impact) {
  return impact.body[0].velocity.e1 + radius * impact.body[0].spin.e3;
}

}  // namespace

// Every law slips to the end at grazing incidence: e_t = 1 − μ(1 + e) cot θ [Walton 1993].
BOOST_AUTO_TEST_CASE(gross_slip_follows_the_sliding_formula) {
  const double angle = 1.4, mu = 0.1;
  for (const auto law : {TangentialLaw::rigid, TangentialLaw::spring, TangentialLaw::mindlin}) {
    const double stiff = law == TangentialLaw::spring ? 1e9 : 1.1e10;
    const auto impact = impact::simulate(strike(angle, {law, mu, stiff}));
    check_near(impact.body[0].velocity.e1 / std::sin(angle), 1 - mu * 2 / std::tan(angle), 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(rigid_stick_leaves_five_sevenths) {
  const auto impact = impact::simulate(strike(0.3, {TangentialLaw::rigid, 0.4, 0}));
  check_near(impact.body[0].velocity.e1 / std::sin(0.3), 5.0 / 7, 1e-10);
  check_near(slip_after(impact), 0, 1e-10);
}

// u' = u cos(π √(7 k_t/2k)) of a linear pair that never slips.
/// From far away, so that its stick begins within a rounded instant: what is left of the slip does not last.
BOOST_AUTO_TEST_CASE(rigid_stick_is_as_right_in_space_as_in_the_plane) {
  auto bodies = strike(0.07, {TangentialLaw::rigid, 0.15, 0});
  bodies.contact[0].touching = false;
  bodies.body[0].position = {-0.1, 20 * radius, 0};
  const auto plane = impact::simulate(bodies, {.accuracy = 1e-12, .max_time = 1});
  bodies.dimension = 3;
  const auto space = impact::simulate(bodies, {.accuracy = 1e-12, .max_time = 1});
  BOOST_TEST(std::abs(slip_after(plane)) < 2e-12);
  BOOST_TEST(std::abs(slip_after(space)) < 2e-12);
  BOOST_TEST(std::abs(space.body[0].velocity.e1 - plane.body[0].velocity.e1) < 2e-12);
  BOOST_TEST(std::abs(space.energy.residual) < 1e-12 * space.energy.initial);
}

BOOST_AUTO_TEST_CASE(a_ball_that_falls_meets_the_plane_as_fast_as_it_must) {
  auto bodies = strike(0, rigid, contact::Viscoelastic{.stiffness = 1e6, .damping = 50, .exponent = 1});
  bodies.body[0].velocity = {};
  bodies.body[0].position.e2 += 0.1;
  bodies.contact[0].touching = false;
  bodies.gravity = {0, -9.81, 0};
  const auto impact = impact::simulate(bodies, {.max_time = 0.2});
  const auto& [approach, separation] = impact.contacts[0].meeting;
  BOOST_TEST(impact.contacts[0].periods.size() == 1u);
  check_near(*approach, std::sqrt(2 * 9.81 * 0.1), 1e-9);
  const double flight = impact.time - *impact.contacts[0].periods[0].end;
  check_near(*separation, impact.body[0].velocity.e2 + 9.81 * flight, 1e-9);
  BOOST_TEST(*separation < *approach);
}

BOOST_AUTO_TEST_CASE(accuracy_of_what_falls_and_comes_to_rest_is_relative_to_how_it_landed) {
  auto bodies = strike(0, {}, contact::Viscoelastic{.stiffness = 1e5, .damping = 100, .exponent = 1});
  bodies.body[0].velocity = {};
  bodies.body[0].position.e2 += 0.05;
  bodies.contact[0].touching = false;
  bodies.gravity = {0, -9.81, 0};
  const hybrid::Options options{.accuracy = 1e-8, .max_time = 0.2, .flies_on = true};
  const auto impact = impact::simulate(bodies, options);
  BOOST_TEST(std::abs(impact.body[0].velocity.e2) < 1e-8);
  BOOST_TEST(impact::estimate_accuracy(bodies, options, impact) < options.accuracy);
  BOOST_TEST(impact.estimated_accuracy.value_or(0) < options.accuracy);
}

BOOST_AUTO_TEST_CASE(linear_springs_turn_the_slip_by_the_ratio_of_their_periods) {
  const double k = 1e6, angle = 0.2;
  for (const double ratio : {0.1, 2.0 / 7, 0.5}) {
    const auto impact =
        impact::simulate(strike(angle, {TangentialLaw::spring, 1e9, ratio * k}, contact::Linear(k)));
    check_near(slip_after(impact), std::sin(angle) * std::cos(std::numbers::pi * std::sqrt(3.5 * ratio)),
               1e-9);
  }
}

// ψ = (k_t/k_n) tan θ/μ with k_t/k_n = (2/3) κ/k: stick from the onset up to ψ = 1; slip to the end from 4χ −
// 2/3 on, with χ = (7/4) k_t/k_n.
BOOST_AUTO_TEST_CASE(onset_and_gross_slip_begin_where_the_theory_says) {
  const double mu = 0.2, ratio = 0.85, kappa = 1.5 * ratio * stiffness;
  const auto events_at = [&](double psi) {
    return impact::simulate(strike(std::atan(psi * mu / ratio), {TangentialLaw::mindlin, mu, kappa})).events;
  };
  BOOST_TEST(!events_at(0.999).front().of(model::BodyEvent::stick).empty());
  BOOST_TEST(!events_at(1.001).front().of(model::BodyEvent::slip).empty());
  const auto sticks = [&](double psi) {
    for (const auto& event : events_at(psi))
      if (!event.of(model::BodyEvent::stick).empty()) return true;
    return false;
  };
  const double limit = 4 * 1.75 * ratio - 2.0 / 3;
  BOOST_TEST(sticks(0.9995 * limit));
  BOOST_TEST(!sticks(1.0005 * limit));
}

// Of two hard balls of which one slides past the other at rest: tan θ = min(μ, tan φ/7) at the cut φ, but for
// turns of the size of δ/R = 2e-6.
BOOST_AUTO_TEST_CASE(friction_throws_a_struck_ball_by_the_smaller_of_two_angles) {
  const double mu = 0.06;
  for (const double cut : {0.1, 0.3, 0.39, 0.41, 0.8, 1.2}) {
    const Vector3 along{std::cos(cut), std::sin(cut), 0};
    model::Bodies bodies{.dimension = 2};
    bodies.body = {ball(-2 * radius * along, {1, 0, 0}), ball({}, {})};
    bodies.contact = {{.a = {0, 0}, .b = {1, 0}, .law = contact::Hertz(1e18), .touching = true}};
    bodies.contact[0].tangential = {TangentialLaw::rigid, mu, 0};
    const auto v = impact::simulate(bodies).body[1].velocity;
    const double thrown = cut - std::atan2(v.e2, v.e1);
    BOOST_TEST(std::abs(std::tan(thrown) - std::min(mu, std::tan(cut) / 7)) < 1e-5, cut << ": " << thrown);
  }
}

BOOST_AUTO_TEST_CASE(stiff_springs_tend_to_rigid_stick) {
  const auto linear = contact::Linear(1e6);
  const double hard =
      impact::simulate(strike(0.5, {TangentialLaw::rigid, 0.5, 0}, linear)).body[0].velocity.e1;
  double last = 1;
  for (const double k : {1e10, 1e12, 1e14}) {
    // A spring rings with the amplitude of u √(m/k_t): that is how far it is from a constraint.
    const double soft =
        impact::simulate(strike(0.5, {TangentialLaw::spring, 0.5, k}, linear)).body[0].velocity.e1;
    BOOST_TEST(std::abs(soft - hard) < last);
    last = std::abs(soft - hard) / 3;
  }
}

BOOST_AUTO_TEST_CASE(momentum_and_angular_momentum_stay_for_every_share) {
  for (const double share : {0.0, 0.2, 0.5, 1.0})
    for (const auto& law : {mindlin, spring, rigid}) {
      const auto impact = impact::simulate(meeting(law, share));
      BOOST_TEST(!impact.contacts[0].periods.empty());
      // Some hundred steps round; their errors partly cancel.
      BOOST_TEST(norm(impact.momentum_residual) <= 64 * epsilon * mass);
      BOOST_TEST(norm(impact.angular_momentum_residual) <= 1e-13 * mass * radius);
      BOOST_TEST(std::abs(impact.energy.residual) <= 1e-10 * impact.energy.initial);
    }
}

BOOST_AUTO_TEST_CASE(rotated_scenes_give_rotated_results) {
  const double angle = 0.7;
  const auto turned = [&](const Vector3& v) { return rotate(rotation({0, 0, 1}, angle), v); };
  for (const auto& law : {mindlin, spring, rigid}) {
    auto other = meeting(law);
    for (auto& body : other.body)
      body.position = turned(body.position), body.velocity = turned(body.velocity);
    const auto a = impact::simulate(meeting(law)), b = impact::simulate(other);
    for (std::size_t i = 0; i < 2; ++i) {
      BOOST_TEST(norm(turned(a.body[i].velocity) - b.body[i].velocity) <= 2e-10);
      BOOST_TEST(radius * norm(a.body[i].spin - b.body[i].spin) <= 2e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_moving_observer_sees_the_same) {
  const Vector3 boost{3, -2, 0};
  auto other = meeting(mindlin);
  for (auto& body : other.body) body.velocity = body.velocity + boost;
  const auto a = impact::simulate(meeting(mindlin)), b = impact::simulate(other);
  for (std::size_t i = 0; i < 2; ++i)
    BOOST_TEST(norm(a.body[i].velocity + boost - b.body[i].velocity) <= 1e-9);  // accuracy × the larger speed
}

BOOST_AUTO_TEST_CASE(a_plane_that_moves_is_a_plane_at_rest_seen_by_others) {
  const Vector3 boost{0.4, 0.25, 0};
  const auto at_rest = strike(0.6, mindlin, contact::Hertz(1e8));
  auto moving = at_rest;
  moving.body[0].velocity = moving.body[0].velocity + boost;
  moving.plane[0].velocity = boost;
  const auto a = impact::simulate(at_rest), b = impact::simulate(moving);
  BOOST_TEST(norm(a.body[0].velocity + boost - b.body[0].velocity) <= 1e-9);
  BOOST_TEST(std::abs(b.energy.residual) <= 1e-9 * b.energy.initial);
}

BOOST_AUTO_TEST_CASE(bodies_may_change_their_places) {
  auto other = meeting(mindlin, 0.5);
  std::swap(other.body[0], other.body[1]);
  const auto a = impact::simulate(meeting(mindlin, 0.5)), b = impact::simulate(other);
  for (std::size_t i = 0; i < 2; ++i) {
    BOOST_TEST(norm(a.body[i].velocity - b.body[1 - i].velocity) <= 2e-10);
    BOOST_TEST(radius * norm(a.body[i].spin - b.body[1 - i].spin) <= 2e-10);
  }
}

BOOST_AUTO_TEST_CASE(a_plane_scene_in_a_tilted_plane_of_space_gives_the_same) {
  const auto tilt = rotation({0.6, 0.8, 0}, 0.9) * rotation({0, 0, 1}, 0.3);
  for (const auto& law : {mindlin, spring, rigid}) {
    auto space = meeting(law);
    space.dimension = 3;
    for (auto& body : space.body) {
      body.position = rotate(tilt, body.position);
      body.velocity = rotate(tilt, body.velocity);
      body.spin = rotate(tilt, body.spin);
    }
    const auto flat = impact::simulate(meeting(law)), tilted = impact::simulate(space);
    for (std::size_t i = 0; i < 2; ++i) {
      BOOST_TEST(norm(rotate(tilt, flat.body[i].velocity) - tilted.body[i].velocity) <= 2e-10);
      BOOST_TEST(radius * norm(rotate(tilt, flat.body[i].spin) - tilted.body[i].spin) <= 2e-10);
    }
  }
}

// Directions turn by about the indentation over the radius: the difference goes with it.
BOOST_AUTO_TEST_CASE(without_friction_and_turning_balls_are_a_network) {
  double last = 1;
  for (const double k : {1e6, 1e9, 1e12}) {
    auto bodies = meeting({});
    bodies.contact[0].law = contact::Hertz(k);
    for (auto& body : bodies.body) body.spin = {};
    const Vector3 apart = bodies.body[1].position - bodies.body[0].position;
    bodies.body[1].position = bodies.body[0].position + (2 * radius / norm(apart)) * apart;
    bodies.contact[0].touching = true;
    auto balls = std::vector<model::Ball>();
    for (const auto& body : bodies.body)
      balls.push_back({.position = {body.position.e1, body.position.e2},
                       .velocity = {body.velocity.e1, body.velocity.e2},
                       .mass = mass,
                       .radius = radius});
    auto network = model::free_balls(balls);
    auto contact = model::ball_contact(balls, 0, 1);
    network.direction.push_back(contact.direction);
    network.gap.push_back(0);
    network.distance.push_back(contact.distance);
    network.law.push_back(contact::Hertz(k));
    const auto turning = impact::simulate(bodies);
    const auto frozen = impact::simulate(network);
    double apart_by = 0;
    for (std::size_t i = 0; i < 2; ++i)
      apart_by = std::max({apart_by, std::abs(turning.body[i].velocity.e1 - frozen.velocity[2 * i]),
                           std::abs(turning.body[i].velocity.e2 - frozen.velocity[2 * i + 1])});
    BOOST_TEST(apart_by < last);
    last = apart_by / 5;
  }
}

namespace {

/// Three balls that meet in the middle; slips stop, turn and start again while others hold.
void check_rings(unsigned seed, double accuracy) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int trial = 0; trial < 60; ++trial) {
    const bool space = trial % 3 == 0;
    model::Bodies bodies{.dimension = space ? 3 : 2};
    for (int i = 0; i < 3; ++i) {
      const double a = 2 * std::numbers::pi * i / 3;
      const Vector3 place{0.013 * std::cos(a), 0.013 * std::sin(a), space ? uniform(-0.001, 0.001) : 0};
      const Vector3 motion{uniform(-0.4, 0.4), uniform(-0.4, 0.4), space ? uniform(-0.1, 0.1) : 0};
      const Vector3 spin{space ? uniform(-30, 30) : 0, space ? uniform(-30, 30) : 0, uniform(-30, 30)};
      bodies.body.push_back(ball(place, motion - 60 * place, spin));
    }
    const double damping = trial % 2 ? 300 : 0;
    for (Index i = 0; i < 3; ++i)
      for (Index j = i + 1; j < 3; ++j) {
        const auto law = static_cast<TangentialLaw>(trial % 4);
        const double k_t = law == TangentialLaw::spring ? 4e4 : 8e6;
        bodies.contact.push_back(
            {.a = {i, 0},
             .b = {j, 0},
             .law = contact::Viscoelastic{.stiffness = 7e6, .damping = damping, .exponent = 1.5},
             .tangential = {law, uniform(0.05, 0.6), k_t},
             .share = uniform(0, 1)});
      }
    const auto impact = impact::simulate(bodies, {.accuracy = accuracy});
    BOOST_TEST_CONTEXT("seed " << seed << ", trial " << trial << ": " << impact.message) {
      BOOST_TEST((impact.ending == hybrid::Ending::separated));
      BOOST_TEST(std::abs(impact.energy.residual) <= 100 * accuracy * impact.energy.initial);
      BOOST_TEST(impact.energy.final <= impact.energy.initial * (1 + accuracy));
      BOOST_TEST(impact.events.size() < 50);
      for (const auto& contact : impact.contacts) {
        const double least = -0.1 * accuracy * impact.energy.initial;
        BOOST_TEST(contact.losses.friction >= least);
        BOOST_TEST(contact.losses.rescale >= least);
        BOOST_TEST(contact.losses.damper >= least);
      }
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_scenes_close_their_ledgers_and_gain_nothing) {
  check_rings(5, 1e-9);
  check_rings(11, 1e-8);
  check_rings(13, 1e-8);
}
