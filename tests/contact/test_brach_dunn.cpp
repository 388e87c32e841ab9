#define BOOST_TEST_MODULE contact_brach_dunn
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/brach_dunn.hpp"
#include "mariotte/contact/coulomb.hpp"
#include "mariotte/series/dual.hpp"

using namespace mariotte::contact;

namespace {

constexpr BrachDunn sample{.stiffness = 2.0, .adhesion = 0.7, .damping_hertz = 0.3, .damping_adhesion = 0.4};
constexpr Surface fluorescein_on_silicon{.stiffness = 1.74e9, .adhesion = 0.38};

}  // namespace

BOOST_AUTO_TEST_CASE(slopes_agree_with_differences) {
  for (const double d : {1e-4, 0.1, 1.0})
    for (const double v : {-2.0, 0.0, 1.5}) {
      using Slopes = mariotte::series::Dual<double, 2>;
      const auto f = normal_force(sample, Slopes(d, {1, 0}), Slopes(v, {0, 1}));
      const double h = 1e-5 * d, g = 1e-5;
      const double by_d = (normal_force(sample, d + h, v) - normal_force(sample, d - h, v)) / (2 * h);
      const double by_v = (normal_force(sample, d, v + g) - normal_force(sample, d, v - g)) / (2 * g);
      BOOST_TEST(std::abs(f.slope[0] - by_d) < 1e-7 * (1 + std::abs(by_d)));
      BOOST_TEST(std::abs(f.slope[1] - by_v) < 1e-7 * (1 + std::abs(by_v)));
    }
}

BOOST_AUTO_TEST_CASE(stored_energy_is_the_integral_of_the_static_force) {
  for (const double d : {0.05, 0.4, 2.0}) {
    const double h = 1e-5 * d;
    const double slope = (stored_energy(sample, d + h) - stored_energy(sample, d - h)) / (2 * h);
    BOOST_TEST(std::abs(slope - normal_force(sample, d, 0.0)) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(both_dampings_take_energy_whatever_the_velocity) {
  for (const double v : {-100.0, -1.0, 1.0, 100.0}) {
    BOOST_TEST(hertz_damping_power(sample, 0.5, v) < 0);
    BOOST_TEST(adhesion_damping_power(sample, 0.5, v) < 0);
    // Together they are the power of the force less that of its static part.
    const double damped = (normal_force(sample, 0.5, v) - normal_force(sample, 0.5, 0.0)) * v;
    const double sum = hertz_damping_power(sample, 0.5, v) + adhesion_damping_power(sample, 0.5, v);
    BOOST_TEST(std::abs(damped - sum) < 1e-12 * std::abs(sum));
  }
}

BOOST_AUTO_TEST_CASE(a_tip_rests_where_the_force_is_zero) {
  const double depth = rest_indentation(sample);
  BOOST_TEST(std::abs(normal_force(sample, depth, 0.0)) < 1e-15);
  BOOST_TEST(stored_energy(sample, depth) < 0);
}

// Values that come with the reference cases of the paper's parameters.
BOOST_AUTO_TEST_CASE(the_published_parameters_give_the_known_coefficients) {
  const double r = 2.45e-6;
  BOOST_TEST(std::abs(line_force(fluorescein_on_silicon, r) / 9.589185551035753 - 1) < 1e-14);
  const double hertz = hertz_damping(1.5, fluorescein_on_silicon, r, 1350, 5);
  const double adhesion = adhesion_damping(0.5, fluorescein_on_silicon, r, 1350, 5);
  BOOST_TEST(std::abs(hertz / 0.0070377708723388995 - 1) < 1e-13);
  BOOST_TEST(std::abs(adhesion / 0.008722815929492133 - 1) < 1e-13);
  const auto law = brach_dunn(fluorescein_on_silicon, r, hertz, adhesion);
  BOOST_TEST(std::abs(rest_indentation(law) - 34.63e-9) < 5e-12);
}

BOOST_AUTO_TEST_CASE(friction_is_limited_by_the_magnitude_of_the_force_whatever_its_sign) {
  BOOST_TEST(limit(Coulomb{0.3}, 2.0) == 0.6);
  BOOST_TEST(limit(Coulomb{0.3}, -2.0) == 0.6);
}
