#define BOOST_TEST_MODULE microbodies side by side
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/microbody/microbody_batch.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "support/allocations.hpp"
#include "support/batch_order.hpp"

using namespace mariotte;
using namespace mariotte::test;
using Bodies = std::vector<model::Microbody>;
using Impacts = std::vector<impact::BriefMicrobodyImpact>;

namespace {

/// Spheres of 0.1 to 100 µm at 0.1 to 100 m/s, with adhesion and dampings over decades or none.
Bodies random_spheres(int count) {
  std::mt19937_64 random(5);
  const auto decades = [&](double low, double high) {
    return std::pow(10.0, std::uniform_real_distribution(low, high)(random));
  };
  const auto maybe = [&](double value) { return random() % 3 == 0 ? 0 : value; };
  Bodies bodies;
  for (int i = 0; i < count; ++i) {
    const double radius = decades(-7, -4), speed = decades(-1, 2);
    model::Microbody body{};
    body.body = model::sphere(radius, decades(3, 4));
    body.friction = {0.2};
    const contact::Surface surface{.stiffness = decades(9, 11), .adhesion = maybe(decades(-4, -0.5))};
    body.law = {contact::brach_dunn(surface, radius, maybe(decades(-3, -0.3)) / speed,
                                    maybe(decades(-3, -0.3)) / speed)};
    body.velocity = {-speed, 0, 0};
    bodies.push_back(std::move(body));
  }
  return bodies;
}

Impacts solve(const Bodies& bodies, double accuracy, const std::vector<Index>& order, Index at_once) {
  Impacts impacts(bodies.size());
  impact::MicrobodyBatch batch([&](Index which, const auto& body, const auto& impact) {
    BOOST_TEST(body.velocity.e1 == bodies[which].velocity.e1);
    BOOST_TEST(body.body.mass == bodies[which].body.mass);
    BOOST_TEST(body.law[0].adhesion == bodies[which].law[0].adhesion);
    impacts[which] = impact;
  });
  put_all(batch, bodies, accuracy, order, at_once);
  return impacts;
}

bool same_bits(const impact::BriefMicrobodyImpact& a, const impact::BriefMicrobodyImpact& b) {
  return a.ending == b.ending && a.velocity == b.velocity && a.spin == b.spin && a.time == b.time &&
         a.events == b.events && a.steps == b.steps;
}

Index openings(const impact::MicrobodyImpact& impact) {
  return std::ssize(impact.impacts) - (impact.ending == hybrid::Ending::captured);
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_spheres_are_what_they_are_in_general) {
  const auto bodies = random_spheres(1500);
  impact::MicrobodySolver solver, general(impact::Course::of_simulate);
  for (const double accuracy : {1e-4, 1e-6, 1e-10, 1e-12}) {
    const auto impacts = solve(bodies, accuracy, in_order(bodies.size()), 1000);
    Index in_lanes = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) BOOST_TEST_CONTEXT("sphere " << i << " at " << accuracy) {
        const auto alone = solver.solve(bodies[i], {.accuracy = accuracy});
        const auto machinery = general.solve(bodies[i], {.accuracy = accuracy});
        const auto exact = impact::simulate(bodies[i], {.accuracy = std::max(1e-14, 1e-3 * accuracy)});
        in_lanes += impacts[i].steps != machinery.steps;
        for (const auto* got : {&impacts[i], &alone}) {
          BOOST_TEST((got->ending == exact.ending));
          BOOST_TEST(got->impacts == openings(exact));
          BOOST_TEST(got->events == machinery.events);
          const double speed = -bodies[i].velocity.e1;
          BOOST_TEST(std::abs(got->velocity.e1 - exact.final.velocity.e1) <= accuracy * speed);
          BOOST_TEST(got->tip_velocity == got->velocity.e1);
          if (got->ending == hybrid::Ending::separated)
            BOOST_TEST(std::abs(got->time / *exact.impacts[0].end - 1) <=
                       accuracy * speed / got->velocity.e1);
        }
      }
    BOOST_TEST(in_lanes > 1000);
  }
}

BOOST_AUTO_TEST_CASE(what_a_sphere_gives_depends_on_no_other) {
  const auto bodies = random_spheres(700);
  auto order = in_order(bodies.size());
  const auto impacts = solve(bodies, 1e-8, order, 1000);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  for (const Index at_once : {1, 3, 700}) {
    const auto others = solve(bodies, 1e-8, order, at_once);
    for (std::size_t i = 0; i < bodies.size(); ++i) BOOST_TEST(same_bits(impacts[i], others[i]));
  }
}

// Near the capture velocity the restitution falls to zero with a vertical slope.
BOOST_AUTO_TEST_CASE(capture_begins_at_the_same_speed) {
  auto body = random_spheres(1).front();
  body.law = {
      contact::brach_dunn({.stiffness = 1e10, .adhesion = 0.1}, body.body.tips[0].radius, 0.02, 0.02)};
  impact::MicrobodySolver solver, general(impact::Course::of_simulate);
  const auto is_captured = [&](impact::MicrobodySolver& by, double speed) {
    body.velocity = {-speed, 0, 0};
    return by.solve(body, {.accuracy = 1e-10}).ending == hybrid::Ending::captured;
  };
  double held = 1e-4, free = 1e3;
  while (free / held > 1 + 1e-9) {
    const double speed = std::sqrt(held * free);
    BOOST_TEST(is_captured(solver, speed) == is_captured(general, speed));
    (is_captured(solver, speed) ? held : free) = speed;
  }
  BOOST_TEST(held > 1e-3);
}

BOOST_AUTO_TEST_CASE(others_are_solved_alone) {
  auto bodies = random_spheres(6);
  bodies[0].velocity.e2 = 0.1;
  bodies[1].spin.e3 = 5;
  bodies[2].gravity = 9.81;
  bodies[3].body = model::rod(1e-6, 3, 2000);
  bodies[3].law.assign(bodies[3].body.tips.size(), bodies[3].law[0]);
  bodies[4].law[0].damping_hertz = 1e7 / -bodies[4].velocity.e1;
  const auto impacts = solve(bodies, 1e-8, in_order(bodies.size()), 1000);
  impact::MicrobodySolver general(impact::Course::of_simulate);
  for (std::size_t i = 0; i < 5; ++i)
    BOOST_TEST_CONTEXT(i) BOOST_TEST(same_bits(impacts[i], general.solve(bodies[i], {.accuracy = 1e-8})));
}

BOOST_AUTO_TEST_CASE(a_body_that_makes_no_sense_harms_no_other) {
  const auto good = random_spheres(3);
  auto bad = good.front();
  bad.velocity.e1 = 1;
  Index taken = 0;
  impact::MicrobodyBatch batch([&](Index, const auto&, const auto&) { ++taken; });
  batch.put(0, good[0], {});
  BOOST_CHECK_THROW(batch.put(1, bad, {}), InvalidParameter);
  BOOST_CHECK_THROW(batch.put(1, good[1], {.accuracy = 2}), InvalidParameter);
  batch.put(2, good[2], {.accuracy = 1e-5});
  batch.finish();
  BOOST_TEST(taken == 2);
}

BOOST_AUTO_TEST_CASE(nothing_is_allocated_after_the_first_of_their_kind) {
  auto body = random_spheres(1).front();
  impact::MicrobodyBatch batch([](Index, const auto&, const auto&) {});
  const auto round = [&] {
    for (int i = 0; i < 500; ++i) {
      body.velocity.e1 = -10 - i;
      batch.put(0, body, {.accuracy = 1e-8});
    }
    batch.finish();
  };
  body.law[0] = {
      .stiffness = body.law[0].stiffness, .adhesion = 0, .damping_hertz = 1e-4, .damping_adhesion = 0};
  round();
  const long before = allocations;
  round();
  BOOST_TEST(allocations == before);
}
