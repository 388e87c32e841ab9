#define BOOST_TEST_MODULE published numbers
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

struct Sphere {
  double radius, young, poisson, density;
};

double mass(const Sphere& s) {
  return 4.0 / 3.0 * std::numbers::pi * s.radius * s.radius * s.radius * s.density;
}

struct HertzPeak {
  double indentation, force, duration;  // µm, N, µs
};

/// Half a unit of the last digit given: 1 nm, 10 mN or 100 mN, 100 ps.
void check_peak(const model::Chain& chain, const HertzPeak& expected) {
  const auto contact = impact::simulate(chain).contacts.at(0);
  BOOST_TEST(std::abs(contact.peak_indentation * 1e6 - expected.indentation) <= 0.5e-3);
  BOOST_TEST(std::abs(contact.peak_force - expected.force) <= (expected.force < 1e4 ? 0.5e-2 : 0.5e-1));
  BOOST_TEST(std::abs(*contact.periods.at(0).end * 1e6 - expected.duration) <= 0.5e-4);
}

/// [Chung & Ooi 2011, test 1]: two equal spheres at ±10 m/s.
void check_spheres(const Sphere& s, const HertzPeak& expected) {
  const contact::Elasticity material{s.young, s.poisson};
  const double stiffness = contact::hertz_stiffness(material, s.radius, material, s.radius);
  check_peak(
      {.mass = {mass(s), mass(s)}, .law = {contact::Hertz{stiffness}}, .gap = {0}, .velocity = {10, -10}},
      expected);
}

/// [Chung & Ooi 2011, test 2]: a sphere on a rigid plane at 0.2 m/s.
void check_plane(const Sphere& s, const HertzPeak& expected) {
  const contact::Elasticity material{s.young, s.poisson}, rigid{infinity, 0};
  const double stiffness = contact::hertz_stiffness(material, s.radius, rigid, infinity);
  check_peak(
      {.mass = {infinity, mass(s)}, .law = {contact::Hertz{stiffness}}, .gap = {0}, .velocity = {0, -0.2}},
      expected);
}

/// N equal balls at unit speed against a wall of their material, k_wall = √2 k.
model::Chain column(std::size_t balls) {
  model::Chain chain{.mass = Numbers(balls + 1, 1.0),
                     .law = {},
                     .gap = Numbers(balls, 0.0),
                     .velocity = Numbers(balls + 1, -1.0)};
  chain.mass[0] = infinity;
  chain.velocity[0] = 0;
  chain.law.assign(balls, contact::Hertz{1});
  chain.law[0] = contact::Hertz{std::numbers::sqrt2};
  return chain;
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_glass_spheres) {
  check_spheres({0.010, 48e9, 0.2, 2800}, {274.113, 10696.9, 40.3395});
}
BOOST_AUTO_TEST_CASE(two_limestone_spheres) {
  check_spheres({0.010, 20e9, 0.25, 2500}, {368.304, 7108.24, 54.2010});
}
BOOST_AUTO_TEST_CASE(aluminium_sphere_on_a_rigid_plane) {
  check_plane({0.100, 70e9, 0.3, 2699}, {49.717, 11369.9, 731.6566});
}
BOOST_AUTO_TEST_CASE(magnesium_sphere_on_a_rigid_plane) {
  check_plane({0.100, 40e9, 0.35, 1800}, {52.123, 7232.68, 767.0659});
}

// Restitution of f = k δ^{3/2} + c δ^{1/2} δ̇ cut off at f = 0 against b = c k^{−3/5} m*^{−2/5} v^{1/5}
// [Müller & Pöschel 2011].
BOOST_AUTO_TEST_CASE(restitution_of_viscoelastic_pairs) {
  const double expected[][2] = {{0.01, 0.988547439643}, {0.1, 0.892858875507}, {0.3, 0.722085439654},
                                {0.5, 0.595251501135},  {1, 0.393930603230},   {2, 0.211646054604},
                                {5, 0.068899657679}};
  const double stiffness = 7e4, m = 0.03, speed = 2.5;  // any: only b counts
  for (const auto& [b, restitution] : expected) {
    const double damping = b * std::pow(stiffness, 0.6) * std::pow(m / 2, 0.4) / std::pow(speed, 0.2);
    const contact::Viscoelastic law{.stiffness = stiffness, .damping = damping, .exponent = 1.5};
    const auto impact = impact::simulate({.mass = {m, m}, .law = {law}, .gap = {0}, .velocity = {speed, 0}},
                                         {.accuracy = 1e-12});
    BOOST_TEST((impact.velocity[1] - impact.velocity[0]) / speed == restitution,
               boost::test_tools::tolerance(1e-10));
  }
}

// [Hinch & Saint-Jean 1999]: the first ball's rebound and the last ball's speed tend to 0.071 and 0.986.
BOOST_AUTO_TEST_CASE(ends_of_a_long_equal_chain) {
  const auto impact = impact::simulate(equal_chain(40), {.accuracy = 1e-11});
  BOOST_TEST(std::abs(impact.velocity.front() + 0.0710850171) < 1e-10);
  BOOST_TEST(std::abs(impact.velocity.back() - 0.9856788571) < 1e-9);
}

// Effective restitution and velocities of a column that hits a wall [Falcon et al. 1998 for the experiment].
BOOST_AUTO_TEST_CASE(column_of_beads_on_a_wall) {
  const double expected[][2] = {{1, 1},        {2, 0.970752}, {3, 0.946371}, {4, 0.932461},
                                {5, 0.930370}, {6, 0.931150}, {8, 0.925005}};
  for (const auto islands : {hybrid::Islands::never, hybrid::Islands::always}) {
    for (const auto& [balls, restitution] : expected) {
      const auto impact = impact::simulate(column(static_cast<std::size_t>(balls)), {.islands = islands});
      double momentum = 0;
      for (const double v : impact.velocity) momentum += v;
      BOOST_TEST(std::abs(momentum / balls - restitution) < 6e-7);
      BOOST_TEST(std::abs(impact.contacts[0].peak_force - (balls == 1 ? 1.313264 : 1.344783)) < 6e-7);
      BOOST_TEST(std::abs(impact.momentum.residual) < 1e-9);
    }
  }
}

// Weak gravity and a high fall: the same impact after 10⁹ units of flight, on clocks that keep its digits.
BOOST_AUTO_TEST_CASE(a_column_dropped_from_high_hits_like_one_thrown) {
  for (const auto islands : {hybrid::Islands::never, hybrid::Islands::always}) {
    auto dropped = column(40);
    dropped.velocity.assign(41, 0.0);
    dropped.gravity = 1e-9;
    dropped.gap[0] = 0.5 / dropped.gravity;
    const auto impact = impact::simulate(dropped, {.islands = islands});
    const auto thrown = impact::simulate(column(40));
    BOOST_TEST(difference(impact.velocity, thrown.velocity) < 100 * dropped.gravity);
    const auto& wall = impact.contacts[0].periods;
    BOOST_TEST(wall.size() == 1u);
    BOOST_TEST(std::abs(*wall[0].end - wall[0].start - *thrown.contacts[0].periods[0].end) < 2e-6);
    BOOST_TEST(std::abs(impact.energy.residual) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(a_bead_more_leans_on_the_wall_for_two_units_more) {
  const auto contact_time = [](std::size_t balls) {
    return *impact::simulate(column(balls)).contacts[0].periods[0].end;
  };
  BOOST_TEST(std::abs((contact_time(40) - contact_time(10)) / 30 - 2.1) < 0.06);
}

BOOST_AUTO_TEST_CASE(velocities_of_columns_from_the_wall) {
  const Numbers three = {0, 0.509677, 1.048326, 1.281110};
  const Numbers five = {0, 0.314795, 0.769735, 1.038365, 1.137191, 1.391763};
  for (const auto islands : {hybrid::Islands::never, hybrid::Islands::always}) {
    BOOST_TEST(difference(impact::simulate(column(3), {.islands = islands}).velocity, three) < 6e-7);
    BOOST_TEST(difference(impact::simulate(column(5), {.islands = islands}).velocity, five) < 6e-7);
  }
}
