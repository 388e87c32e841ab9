// Bodies that adhesion hardly lets go: an error of the energy counts as many times in the rebound as it is
// slower than the approach.
#define BOOST_TEST_MODULE near capture
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "mariotte/contact/jkr.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/microbody/microbody_batch.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/impact/network/network_solver.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using hybrid::Ending;

namespace {

/// Of a tenth of a micrometre.
model::Microbody microsphere(double speed) {
  const double size = 1.0979474538486734e-07, moment = 1.9353708136594767e-31;
  model::Microbody body;
  body.body = {.mass = 4.01366465708726e-17, .inertia = {moment, moment, moment}, .tips = {{{}, size}}};
  body.law = {contact::brach_dunn({.stiffness = 7820773143.469456, .adhesion = 0.05269878988744364}, size,
                                  0.043623775591228056, 0.00032240888307589517)};
  body.velocity = {-speed, 0, 0};
  return body;
}

/// Rebounds computed in extended precision elsewhere, at v_c (1 + 10⁻⁸) and faster; 1e-12 is rounding of v_c.
constexpr double edge = 1.0566225714938857, rebound = 1.10784072e-4;

constexpr double modulus = 1.3, radius = 0.8, work = 0.002;

/// ∫ f dδ of the JKR curve from a = 0 to u = √a.
double jkr_energy(double u) {
  const double s = std::sqrt(2 * std::numbers::pi * work / modulus), q = u * u * u / radius;
  return modulus * std::pow(u, 4) * (8.0 / 15 * q * q - 4.0 / 3 * s * q + 0.5 * s * s);
}

/// A mass of one is captured below it: it snaps in at δ = 0 and is let go where dδ/du = 0.
double jkr_capture() {
  const double s = std::sqrt(2 * std::numbers::pi * work / modulus);
  return std::sqrt(2 * (jkr_energy(std::cbrt(s * radius / 4)) - jkr_energy(std::cbrt(s * radius))));
}

model::Chain sticky_ball(double speed) {
  return {.mass = {1, infinity},
          .law = {contact::state(contact::Jkr(modulus, radius, work, 0))},
          .gap = {0.01},
          .velocity = {speed, 0}};
}

model::Bodies sticky_body(double speed) {
  model::Bodies bodies{.dimension = 2};
  bodies.body = {{.mass = 1,
                  .inertia = {0.4, 0.4, 0.4},
                  .spheres = {{{}, radius}},
                  .position = {0, radius + 0.01, 0},
                  .velocity = {0, -speed, 0}}};
  bodies.plane = {{.point = {}, .normal = {0, 1, 0}, .velocity = {}}};
  bodies.contact = {
      {.a = {0, -1}, .b = {0, 0}, .law = contact::state(contact::Jkr(modulus, radius, work, 0))}};
  bodies.named = 1;
  return bodies;
}

/// The error is within what was asked, or what the result says.
template <class Impact>
void expect_kept(const Impact& impact, double error, double accuracy) {
  BOOST_TEST_REQUIRE(impact.estimated_accuracy.has_value());
  BOOST_TEST(error <= std::max(accuracy, *impact.estimated_accuracy));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sphere_that_hardly_comes_off_is_as_exact_as_was_asked) {
  impact::MicrobodySolver solver;
  for (const double accuracy : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto impact = impact::simulate(microsphere(edge), {.accuracy = accuracy});
    BOOST_TEST_CONTEXT("accuracy " << accuracy) {
      BOOST_TEST_REQUIRE((impact.ending == Ending::separated));
      expect_kept(impact, std::abs(impact.restitution.tip - rebound), accuracy);
      BOOST_TEST(*impact.estimated_accuracy < std::max(accuracy, 1e-9));
      const auto& brief = solver.solve(microsphere(edge), {.accuracy = accuracy});
      expect_kept(brief, std::abs(brief.velocity.e1 / edge - rebound), accuracy);
    }
  }
}

BOOST_AUTO_TEST_CASE(sweeps_see_what_hardly_comes_off) {
  impact::MicrobodySolver solver;
  std::vector<double> rebounds;
  impact::MicrobodyBatch batch(
      [&](Index, const model::Microbody&, const impact::BriefMicrobodyImpact& impact) {
        rebounds.push_back(impact.velocity.e1);
      });
  batch.put(0, microsphere(edge), {.accuracy = 1e-6});
  batch.finish();
  BOOST_TEST_REQUIRE(rebounds.size() == 1u);
  BOOST_TEST(rebounds[0] == solver.solve(microsphere(edge), {.accuracy = 1e-6}).velocity.e1);
}

// Below v_c by 10⁻⁸, and by no more than rounding.
BOOST_AUTO_TEST_CASE(at_the_edge_a_capture_says_how_fast_it_could_have_come_off) {
  const double threshold = edge / (1 + 1e-8);
  const auto below = impact::simulate(microsphere(threshold * (1 - 1e-8)), {.accuracy = 1e-6});
  BOOST_TEST((below.ending == Ending::captured));
  expect_kept(below, 0, 1e-6);
  for (const int i : {-2, -1, 0, 1, 2}) {
    const double speed = threshold * (1 + i * 1e-14), exact = std::sqrt(std::max(0.0, i * 1e-14)) * 1.1078;
    const auto impact = impact::simulate(microsphere(speed), {.accuracy = 1e-10});
    const double e = impact.final.velocity.e1 / speed;
    BOOST_TEST_CONTEXT("place " << i) expect_kept(impact, std::abs(e - exact), 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(what_comes_off_fast_is_run_once) {
  for (const double share : {1.05, 2.0, 10.0})
    BOOST_TEST(!impact::simulate(microsphere(share * edge)).estimated_accuracy);
  auto slow = microsphere(edge);  // damping alone: no square root magnifies its errors
  slow.law[0].adhesion = 0;
  slow.law[0].damping_hertz = 20;
  const auto impact = impact::simulate(slow);
  BOOST_TEST(impact.restitution.tip < 0.1);
  BOOST_TEST(!impact.estimated_accuracy);
}

// e = √(1 − v_c²/v²).
BOOST_AUTO_TEST_CASE(contacts_that_snap_off_keep_their_accuracy_near_capture) {
  impact::ChainSolver chains;
  impact::NetworkSolver networks;
  for (const double above : {1e-4, 1e-6, 1e-8, 1e-10})
    for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
      const double speed = jkr_capture() * (1 + above), e = std::sqrt(1 - 1 / ((1 + above) * (1 + above)));
      const auto expect = [&](const auto& impact, double velocity) {
        expect_kept(impact, std::abs(std::abs(velocity) / speed - e), accuracy);
      };
      const auto ball = sticky_ball(speed);
      const auto chain = impact::simulate(ball, {.accuracy = accuracy});
      const auto network = impact::simulate(model::as_network(ball), {.accuracy = accuracy});
      const auto bodies = impact::simulate(sticky_body(speed), {.accuracy = accuracy, .max_time = 1e3});
      BOOST_TEST_CONTEXT("above " << above << " accuracy " << accuracy) {
        expect(chain, chain.velocity[0]);
        expect(network, network.velocity[0]);
        if (above > 1e-9) expect(bodies, bodies.body[0].velocity.e2);
        BOOST_TEST(chains.solve(ball, {.accuracy = accuracy}).velocity[0] == chain.velocity[0]);
        BOOST_TEST(networks.solve(model::as_network(ball), {.accuracy = accuracy}).velocity[0] ==
                   network.velocity[0]);
      }
    }
}
