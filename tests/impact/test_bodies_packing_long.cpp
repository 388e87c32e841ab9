#define BOOST_TEST_MODULE packing of two hundred balls with friction
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "mariotte/impact/bodies/bodies_impact.hpp"

using namespace mariotte;

namespace {

constexpr double radius = 0.01, mass = 0.03;

/// Balls in the plane, as near as chance puts them, that fly towards the middle with spin.
model::Bodies packing(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const double half = 0.5 * radius * std::sqrt(count * std::numbers::pi / 0.5);
  const double moment = 0.4 * mass * radius * radius;
  model::Bodies bodies{.dimension = 2};
  while (std::ssize(bodies.body) < count) {
    const Vector3 place{in(-half, half), in(-half, half), 0};
    const auto overlaps = [&](const model::Body& other) {
      return norm(place - other.position) < 2.02 * radius;
    };
    if (std::any_of(bodies.body.begin(), bodies.body.end(), overlaps)) continue;
    bodies.body.push_back({.mass = mass,
                           .inertia = {moment, moment, moment},
                           .spheres = {{{}, radius}},
                           .position = place,
                           .velocity = -8.0 * place + Vector3{in(-0.1, 0.1), in(-0.1, 0.1), 0},
                           .spin = {0, 0, in(-20, 20)}});
  }
  for (Index b = 0; b < count; ++b)
    for (Index a = 0; a < b; ++a)
      bodies.contact.push_back({.a = {a, 0},
                                .b = {b, 0},
                                .law = contact::Hertz(1e9),
                                .tangential = {model::TangentialLaw::mindlin, 0.3, 8e8}});
  return bodies;
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_hundred_balls_with_friction_come_to_their_end_with_closed_balances) {
  const auto run = impact::simulate(packing(200, 7), {.accuracy = 1e-6});
  BOOST_TEST((run.ending == hybrid::Ending::separated), run.message);
  BOOST_TEST(std::abs(run.energy.residual) < 1e-6 * run.energy.initial);
  BOOST_TEST(run.energy.final < run.energy.initial);
  BOOST_TEST(norm(run.momentum_residual) < 1e-9);
  BOOST_TEST(norm(run.angular_momentum_residual) < 1e-9);
  BOOST_TEST(run.contacts.size() > 300);
  for (const auto& contact : run.contacts) {
    BOOST_TEST(contact.losses.friction >= -1e-9 * run.energy.initial);
    BOOST_TEST(contact.losses.rescale >= -1e-9 * run.energy.initial);
    BOOST_TEST(contact.normal_impulse > 0);
  }
}
