#define BOOST_TEST_MODULE flow_flight
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

#include "mariotte/flow/flight.hpp"

using namespace mariotte;
using namespace mariotte::flow;

namespace {

/// First sample below zero on a fine grid, or −1.
double by_sampling(const TipHeight& h, double end, int samples) {
  for (int i = 1; i <= samples; ++i)
    if (const double t = end * i / samples; h.at(t) < 0) return t;
  return -1;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_tip_that_does_not_turn_falls_on_a_parabola) {
  BOOST_TEST(first_touch({.start = 3, .rate = -2, .gravity = 0}) == 1.5);
  BOOST_TEST(first_touch({.start = 3, .rate = 2, .gravity = 0}) == infinity);
  BOOST_TEST(std::abs(first_touch({.start = 0, .rate = 2, .gravity = 4}) - 1) < 1e-15);
  BOOST_TEST(first_touch({.start = 1, .rate = 0, .gravity = 0}) == infinity);
}

BOOST_AUTO_TEST_CASE(no_touch_is_missed_and_none_is_made_up) {
  std::mt19937 random(20021);
  std::uniform_real_distribution<double> one(-1, 1), positive(0, 1);
  int touches = 0;
  for (int i = 0; i < 4000; ++i) {
    const TipHeight h{.start = i % 3 == 0 ? 0 : positive(random),
                      .rate = one(random),
                      .gravity = i % 2 == 0 ? 0 : 0.1 * positive(random),
                      .swing = positive(random),
                      .turn = 5 * positive(random),
                      .phase = std::numbers::pi * one(random)};
    if (h.start == 0 && h.slope(0) < 0) continue;
    constexpr double end = 60;
    const double touch = first_touch(h), seen = by_sampling(h, end, 20000);
    if (seen < 0) {
      BOOST_TEST((touch > end - 0.01 || std::abs(h.slope(touch)) < 0.02));  // a graze between two samples
      continue;
    }
    ++touches;
    BOOST_TEST(touch <= seen);
    BOOST_TEST(std::abs(h.at(touch)) < 1e-12);
    if (touch < seen - end / 20000) BOOST_TEST(std::abs(h.slope(touch)) < 0.05);
  }
  BOOST_TEST(touches > 2000);
}

// Up for seconds, turning ten million times: nothing is looked at where no touch can be.
BOOST_AUTO_TEST_CASE(a_long_flight_costs_no_more_than_its_two_ends) {
  const double rise = 27, gravity = 9.81, swing = 1e-6;
  const std::clock_t start = std::clock();
  for (int i = 0; i < 100; ++i) {
    const TipHeight h{.start = 0, .rate = rise, .gravity = gravity, .swing = swing, .turn = 1e7 + i};
    const double touch = first_touch(h);
    BOOST_TEST(std::abs(touch - 2 * rise / gravity) < 2 * swing / rise);
    BOOST_TEST(std::abs(h.at(touch)) < 1e-6 * swing + 64 * epsilon * touch * rise);
  }
  BOOST_TEST(static_cast<double>(std::clock() - start) < CLOCKS_PER_SEC);
}

BOOST_AUTO_TEST_CASE(a_symmetric_body_keeps_its_angular_momentum_in_flight) {
  const SymmetricBody body{.mass = 1, .axial = 0.5, .transverse = 2, .arm = {}, .radius = {}, .gravity = 0};
  const Vector3 momentum{0.3, -1.2, 0.7};
  const auto start = from_euler({0.2, 0.9, -0.4});
  const auto spin = [&](const Quaternion& q) {
    const Vector3 h = rotate(conjugate(q), momentum);
    return rotate(q, {h.e1 / body.axial, h.e2 / body.transverse, h.e3 / body.transverse});
  };
  // The rate of the attitude is that of the spin at every time.
  for (const double t : {0.0, 0.5, 3.0}) {
    const double step = 1e-5;
    const auto q = flown(start, momentum, body, t), ahead = flown(start, momentum, body, t + step),
               behind = flown(start, momentum, body, t - step);
    const auto rate = quaternion_rate(q, spin(q));
    BOOST_TEST(std::abs((ahead.w - behind.w) / (2 * step) - rate.w) < 1e-8);
    BOOST_TEST(std::abs((ahead.x - behind.x) / (2 * step) - rate.x) < 1e-8);
    BOOST_TEST(std::abs((ahead.y - behind.y) / (2 * step) - rate.y) < 1e-8);
    BOOST_TEST(std::abs((ahead.z - behind.z) / (2 * step) - rate.z) < 1e-8);
  }
}
