#define BOOST_TEST_MODULE contact_limits
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/contact/limits.hpp"

using namespace mariotte;
using boost::test_tools::tolerance;

namespace {

/// A silica sphere of 5 µm on a plane.
constexpr double radius = 5e-6;
constexpr contact::Surface silica{.stiffness = 5e10, .adhesion = 0.05};

contact::BrachDunn damped() {
  return contact::brach_dunn(silica, radius, 2e-2, 3e-2);
}

}  // namespace

BOOST_AUTO_TEST_CASE(first_yield_speed_is_that_of_johnson) {
  // v² = 107 R³Y⁵/(mE*⁴), three digits of 2 (8/15) (π/2)⁵ 1.60⁵ = 106.97 [Johnson 1985, eq. 11.22]
  const double modulus = 1.1e11, mass = 0.03, yield = 7e8, size = 0.01;
  const double printed =
      std::sqrt(107 * std::pow(size, 3) * std::pow(yield, 5) / (mass * std::pow(modulus, 4)));
  BOOST_TEST(contact::speed_of_pressure(modulus, size, mass, contact::first_yield * yield) == printed,
             tolerance(3e-4));
}

BOOST_AUTO_TEST_CASE(pressure_carries_the_force) {
  // F = (2/3) p₀ π a² with a² = Rδ is k δ^{3/2}
  const double stiffness = 3e9, size = 0.02, depth = 1e-5;
  const double pressure = contact::peak_pressure(contact::contact_modulus(stiffness, size), size, depth);
  BOOST_TEST(2.0 / 3 * pressure * std::numbers::pi * size * depth == stiffness * std::pow(depth, 1.5),
             tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_wave_crosses_a_ball_twice) {
  BOOST_TEST(contact::wave_travel(0.01, 8000, 2e11) == 0.04 / 5000, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(tabor_number_finds_the_work_of_adhesion_in_the_law) {
  const double modulus = 0.75 * silica.stiffness;
  const double expected =
      std::cbrt(radius * std::pow(silica.adhesion / modulus, 2) / std::pow(contact::reach_of_adhesion, 3));
  BOOST_TEST(contact::tabor_number(damped(), radius) == expected, tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(well_damping_is_that_of_the_slopes_of_the_force) {
  const auto law = damped();
  const double rest = contact::rest_indentation(law), mass = 1e-12, step = 1e-6 * rest;
  const double slope =
      (contact::normal_force(law, rest + step, 0.0) - contact::normal_force(law, rest - step, 0.0)) /
      (2 * step);
  const double damping = contact::normal_force(law, rest, -1.0);  // of an indentation rate of 1 m/s
  BOOST_TEST(contact::well_damping(law, mass) == damping / (2 * std::sqrt(slope * mass)), tolerance(1e-6));
}
