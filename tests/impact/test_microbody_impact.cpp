// What a run of a microbody reports, beyond the reference cases.
#define BOOST_TEST_MODULE impact_microbody_impact
#include <boost/test/unit_test.hpp>

#include "mariotte/core/error.hpp"
#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/microbody/microbody_gate.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "support/flow_steps.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

model::Microbody sphere_at(double speed, double damping_hertz, double damping_adhesion) {
  model::Microbody body;
  body.body = model::sphere(2.45e-6, density);
  body.law = {contact::brach_dunn(table_1, 2.45e-6, damping_hertz, damping_adhesion)};
  body.velocity = {-speed, 0, 0};
  return body;
}

/// No two moments equal and tips off the axis.
model::Microbody lopsided() {
  model::Microbody body;
  body.body = {
      .mass = 5e-13,
      .inertia = {3e-24, 2e-23, 2.1e-23},
      .tips = {{.centre = {-9e-6, 0.5e-6, 0}, .radius = 2e-6}, {.centre = {8e-6, 0, 1e-6}, .radius = 3e-6}}};
  for (const auto& tip : body.body.tips)
    body.law.push_back(contact::brach_dunn(table_1, tip.radius, 0.007, 0.009));
  body.friction = {0.3};
  body.attitude = from_euler({0.2, 1.1, -0.3});
  body.velocity = {-5, 0.4, -0.7};
  body.spin = {2e5, 1e5, -5e4};
  return body;
}

double lost_share(const impact::MicrobodyImpact& impact) {
  return std::abs(impact.energy.residual) / impact.energy.initial;
}

bool skips(const impact::MicrobodyImpact& impact, const std::string& what) {
  return std::any_of(impact.skipped.begin(), impact.skipped.end(),
                     [&](const auto& one) { return one.what == what; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_damping_a_sphere_rebounds_as_fast_as_it_came) {
  for (const double speed : {0.01, 1.0, 50.0}) {
    const auto impact = impact::simulate(sphere_at(speed, 0, 0));
    BOOST_TEST((impact.ending == hybrid::Ending::separated));
    BOOST_TEST(std::abs(impact.restitution.tip - 1) < 1e-9);
    BOOST_TEST(skips(impact, "dissipation of the contact"));
  }
}

// Hertz theory: δ_max = (5 m v² / 4 k)^{2/5}, duration 2.94328 δ_max / v, F_max = k δ_max^{3/2}.
BOOST_AUTO_TEST_CASE(without_adhesion_and_damping_the_contact_is_that_of_hertz) {
  auto body = sphere_at(3, 0, 0);
  body.law[0].adhesion = 0;
  const double k = body.law[0].stiffness, depth = std::pow(5 * body.body.mass * 9 / (4 * k), 0.4);
  const auto impact = impact::simulate(body);
  const auto& one = impact.impacts.at(0);
  BOOST_TEST(std::abs(one.peak_indentation / depth - 1) < 1e-9);
  BOOST_TEST(std::abs(one.peak_force / (k * depth * std::sqrt(depth)) - 1) < 1e-9);
  BOOST_TEST(std::abs(*one.end / (2.94328 * depth / 3) - 1) < 2e-6);
  BOOST_TEST(one.peak_pull == 0);
  BOOST_TEST(skips(impact, "adhesion"));
}

BOOST_AUTO_TEST_CASE(a_captured_sphere_comes_to_rest_in_the_well) {
  auto body = sphere_at(0.5, 0.05, 0.05);
  const auto stopped = impact::simulate(body);
  BOOST_TEST((stopped.ending == hybrid::Ending::captured));
  BOOST_REQUIRE(stopped.rest.has_value());
  BOOST_TEST(std::abs(stopped.rest->indentation - 34.63e-9) < 0.01e-9);
  BOOST_TEST(stopped.restitution.tip == 0);
  body.after_capture = model::AfterCapture::go_on;
  const auto rested = impact::simulate(body, {.max_time = 5e-5});
  BOOST_TEST((rested.ending == hybrid::Ending::time_limit));
  const double depth = body.body.tips[0].radius - rested.final.position.e1;
  BOOST_TEST(std::abs(depth / stopped.rest->indentation - 1) < 1e-6);
  BOOST_TEST(norm(rested.final.velocity) < 1e-6 * 0.5);
  BOOST_TEST(lost_share(rested) < 1e-8);
}

// What rounding makes of its rest bounds the steps of BDF more than those of the series.
BOOST_AUTO_TEST_CASE(a_sphere_that_rests_for_long_is_left_to_the_series) {
  auto body = sphere_at(0.5, 0.05, 0.05);
  body.after_capture = model::AfterCapture::go_on;
  const auto rested = impact::simulate(body, {.max_time = 2e-3});
  BOOST_TEST((rested.ending == hybrid::Ending::time_limit));
  BOOST_TEST(steps(rested, flow::Kind::cvode_bdf_klu) < 3000);
  BOOST_TEST(steps(rested, flow::Kind::taylor) < 50'000);
  BOOST_TEST(norm(rested.final.velocity) < 1e-9 * 0.5);
}

// Adhesion holds and damps these so strongly that they creep to their rest: the sign of the force is
// rounding.
BOOST_AUTO_TEST_CASE(an_overdamped_tip_is_captured_without_turning_back) {
  impact::MicrobodySolver solver;
  for (const double radius : {5e-9, 7e-9, 10e-9})
    for (const double speed : {300.0, 100.0}) {
      auto body = sphere_at(speed, 0, 0);
      body.body = model::sphere(radius, density);
      body.law = {contact::brach_dunn(table_1, radius,
                                      contact::hertz_damping(1.5, table_1, radius, density, speed),
                                      contact::adhesion_damping(0.5, table_1, radius, density, speed))};
      body.friction = {0.15};
      const auto impact = impact::simulate(body, {.max_events = 20});
      BOOST_TEST((impact.ending == hybrid::Ending::captured), hybrid::name(impact.ending));
      const double depth = radius - impact.final.position.e1;
      BOOST_TEST(std::abs(depth / contact::rest_indentation(body.law[0]) - 1) < 1e-6);
      BOOST_TEST((solver.solve(body, {.max_events = 20}).ending == hybrid::Ending::captured));
    }
}

// Its weight presses this sphere more than adhesion holds it, and its damping keeps it from turning back.
// What it does in the plane is nothing to that.
BOOST_AUTO_TEST_CASE(an_overdamped_sphere_that_rolls_is_captured_as_one_that_slides) {
  constexpr double radius = 3e-4, along = 0.046;
  const auto landing = [&](double friction) {
    auto body = sphere_at(0.46, 0, 0);
    body.body = model::sphere(radius, 2500);
    body.law = {contact::brach_dunn({.stiffness = 14e9, .adhesion = 1e-4}, radius, 2e6, 0)};
    body.friction = {friction};
    body.velocity.e3 = -along;
    body.gravity = 9.81;
    return impact::simulate(body, {.max_time = 1});
  };
  const auto slides = landing(0);
  for (const double friction : {0.0, 0.1, 1.0}) {
    const auto impact = landing(friction);
    BOOST_TEST((impact.ending == hybrid::Ending::captured), hybrid::name(impact.ending));
    BOOST_TEST(impact.final.time == slides.final.time, boost::test_tools::tolerance(1e-5));
    BOOST_TEST(std::abs(impact.final.velocity.e1) < 1e-10 * 0.46);
    BOOST_TEST(impact.final.position.e1 == slides.final.position.e1, boost::test_tools::tolerance(1e-12));
    const double rolling = friction > 0 ? 5.0 / 7 * along : along;
    BOOST_TEST(impact.final.velocity.e3 == -rolling, boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(a_run_that_ends_within_its_first_contact_has_no_restitution) {
  BOOST_TEST(!has_restitution(impact::simulate(sphere_at(5, 0.007, 0.009), {.max_time = 1e-8})));
  BOOST_TEST(has_restitution(impact::simulate(sphere_at(5, 0.007, 0.009))));
  BOOST_TEST(has_restitution(impact::simulate(sphere_at(0.5, 0.05, 0.05))));
}

// What a run would leave if its flow were wrong, made by hand from what it left.
BOOST_AUTO_TEST_CASE(a_state_that_does_not_balance_is_not_believed) {
  model::MicrobodySystem system(lopsided(), 1e-9, /*balance=*/true);
  const auto start = initial_state(system.body(), system.layout());
  hybrid::Workspace<model::MicrobodySystem> workspace;
  const auto run = hybrid::simulate(system, start, {.accuracy = 1e-9}, workspace);
  const auto verdict = [&](Index component, double change) {
    auto spoilt = run.state;
    spoilt[component] += change;
    auto ending = run.ending;
    std::string message;
    pass_gate(impact::balances(system, start, spoilt, workspace.mode), ending, message);
    BOOST_TEST((ending == hybrid::Ending::unsure) == !message.empty());
    return message;
  };
  const auto& place = system.layout().place;
  BOOST_TEST(verdict(place.velocity, 0) == "");
  BOOST_TEST(verdict(place.velocity, 1e-3).find("energy") != std::string::npos);
  BOOST_TEST(verdict(place.velocity, NAN).find("final state") != std::string::npos);
  BOOST_TEST(verdict(place.work, 1e-3).find("energy balance") != std::string::npos);
  BOOST_TEST(verdict(place.gap[0], -1e3).find("off by") != std::string::npos);
  const double friction = run.state[place.work + 2];
  BOOST_TEST(verdict(place.work + 2, -friction - 1e-3).find("off by") != std::string::npos);
  BOOST_TEST(verdict(place.attitude, 1e-3).find("off by") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_body_without_symmetry_is_followed_in_contact_and_flight) {
  auto body = lopsided();
  body.impacts = 3;
  const auto impact = impact::simulate(body, {.accuracy = 1e-9});
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_TEST(impact.impacts.size() >= 2);
  BOOST_TEST(impact.energy.friction > 0);
  BOOST_TEST(lost_share(impact) < 1e-8);
  BOOST_TEST(!skips(impact, "integration of free flight"));
  const auto other = impact::simulate(body, {.accuracy = 1e-9, .flow = flow::Kind::cvode_bdf_dense});
  BOOST_TEST(norm(impact.final.velocity - other.final.velocity) < 1e-7 * norm(body.velocity));
  BOOST_TEST(reach(body) * norm(impact.final.spin - other.final.spin) < 1e-7 * norm(body.velocity));
}

// The tip that opens is as far below the mass centre as any can be, so nothing can touch again.
BOOST_AUTO_TEST_CASE(a_body_that_leaves_at_the_reach_of_its_tips_is_over) {
  model::Microbody body;
  body.body = {
      .mass = 4e-14, .inertia = {5e-26, 4.8e-26, 4.5e-26}, .tips = {{.centre = {}, .radius = 1.25e-6}}};
  body.law = {contact::brach_dunn(table_1, 1.25e-6, 0, 0)};
  body.friction = {0.3};
  body.velocity = {-5, -5, 0};
  body.spin = {-8e5, 0, 0};
  body.impacts = 2;
  auto upright = body;
  upright.body.inertia = {5e-26, 9.8e-26, 9.5e-26};
  upright.body.tips = {{.centre = {-2e-6, 0, 0}, .radius = 1.25e-6},
                       {.centre = {2e-6, 0, 0}, .radius = 1.25e-6}};
  upright.law.push_back(upright.law.front());
  upright.friction = {};
  upright.velocity = {-5, 0, 0};
  upright.spin = {};
  for (const auto& one : {body, upright}) {
    const auto impact = impact::simulate(one, {.accuracy = 1e-10, .max_time = 1});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(impact.impacts.size() == 1);
    BOOST_TEST(impact.final.velocity.e1 == 5, boost::test_tools::tolerance(1e-9));
  }
}

// In flight nothing turns a body: Rᵀ-components of the angular momentum precess, its space components do not.
BOOST_AUTO_TEST_CASE(angular_momentum_and_energy_are_kept_in_flight_with_the_gyroscopic_term) {
  auto body = lopsided();
  body.impacts = 10;
  const auto first = impact::simulate(body, {.accuracy = 1e-11, .max_time = 2e-7});
  const auto later = impact::simulate(body, {.accuracy = 1e-11, .max_time = 4e-7});
  BOOST_REQUIRE(first.impacts.size() == later.impacts.size());
  const auto momentum = [&](const impact::BodyState& state) {
    const auto& i = body.body.inertia;
    const Vector3 w = rotate(conjugate(state.attitude), state.spin);
    return rotate(state.attitude, {i.e1 * w.e1, i.e2 * w.e2, i.e3 * w.e3});
  };
  const Vector3 before = momentum(first.final), after = momentum(later.final);
  BOOST_TEST(norm(after - before) < 1e-10 * norm(before));
  BOOST_TEST(norm(later.final.spin - first.final.spin) > 1e-3 * norm(first.final.spin));
  BOOST_TEST(norm(later.final.velocity - first.final.velocity) == 0);
}

BOOST_AUTO_TEST_CASE(a_rod_that_lands_flat_has_both_tips_in_contact_and_does_not_turn) {
  auto body = sphere_at(5, 0.007, 0.009);
  body.body = model::rod(2.45e-6, 10, density);
  body.law.push_back(body.law[0]);
  body.friction = {0.5};
  body.attitude = from_euler({0, std::numbers::pi / 2, 0});
  body.impacts = 2;
  const auto impact = impact::simulate(body, {.accuracy = 1e-9});
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_REQUIRE(impact.impacts.size() == 2);
  BOOST_TEST(std::abs(*impact.impacts[0].end - *impact.impacts[1].end) < 1e-8 * *impact.impacts[0].end);
  BOOST_TEST(reach(body) * norm(impact.final.spin) < 1e-7 * 5);
  // Half the mass on each tip: the impact of a sphere of that mass.
  auto half = sphere_at(5, 0.007, 0.009);
  half.body.mass = body.body.mass / 2;
  BOOST_TEST(std::abs(impact.restitution.tip - impact::simulate(half).restitution.tip) < 1e-8);
}

BOOST_AUTO_TEST_CASE(limits_keep_what_was_computed) {
  const auto late = impact::simulate(sphere_at(5, 0.007, 0.009), {.max_time = 1e-8});
  BOOST_TEST((late.ending == hybrid::Ending::time_limit));
  BOOST_TEST(late.final.time == 1e-8);
  BOOST_TEST(late.final.velocity.e1 > -5.5);
  BOOST_TEST(late.energy.stored != 0);
  BOOST_TEST(lost_share(late) < 1e-9);
  const auto few = impact::simulate(lopsided(), {.max_events = 1});
  BOOST_TEST((few.ending == hybrid::Ending::event_limit));
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_by_name) {
  const auto message = [](const model::Microbody& body) -> std::string {
    try {
      impact::simulate(body);
    } catch (const InvalidParameter& error) {
      return error.what();
    }
    return "accepted";
  };
  auto body = sphere_at(5, 0, 0);
  body.friction = {-0.1};
  BOOST_TEST(message(body).find("friction") != std::string::npos);
  body = sphere_at(-1, 0, 0);
  BOOST_TEST(message(body) == "the body does not approach the plane");
  body = sphere_at(5, 0, 0);
  body.body.tips[0].radius = 0;
  BOOST_TEST(message(body).find("radius") != std::string::npos);
  body = lopsided();
  std::swap(body.body.tips[0], body.body.tips[1]);
  BOOST_TEST(message(body) == "tip 2 starts below the plane");
}

BOOST_AUTO_TEST_CASE(the_solver_gives_what_a_full_run_gives) {
  impact::MicrobodySolver solver;
  for (const auto* file : {"sphere_oblique.json", "rod_events.json", "spatial.json", "secondary.json"})
    for (const auto& c : body_cases(file)) {
      const auto body = microbody(c);
      const auto full = impact::simulate(body, {.accuracy = 1e-9});
      const auto& brief = solver.solve(body, {.accuracy = 1e-9});
      BOOST_TEST((brief.ending == full.ending));
      BOOST_TEST(norm(brief.velocity - full.final.velocity) < 1e-8 * speed_scale(body));
      BOOST_TEST(reach(body) * norm(brief.spin - full.final.spin) < 1e-8 * speed_scale(body));
      BOOST_TEST(brief.impacts == std::ssize(full.impacts) - (full.ending == hybrid::Ending::captured));
    }
}
