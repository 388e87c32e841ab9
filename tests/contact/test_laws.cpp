#define BOOST_TEST_MODULE contact laws
#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/law.hpp"

using namespace mariotte::contact;

namespace {

template <class L>
struct Sample;
template <>
struct Sample<Linear> {
  static Linear law() { return {3.0}; }
};
template <>
struct Sample<Hertz> {
  static Hertz law() { return {3.0}; }
};
template <>
struct Sample<Viscoelastic> {
  static Viscoelastic law() { return {.stiffness = 3.0, .damping = 0.4, .exponent = 1.7}; }
};
// The new law's line: one entry here covers it.
using Laws = boost::mpl::list<Linear, Hertz, Viscoelastic>;

constexpr double indentations[] = {1e-6, 0.01, 0.3, 2.0};
constexpr double rates[] = {-0.5, -1e-3, 0.0, 0.2, 3.0};

template <class Visit>
void for_each_state(Visit&& visit) {
  for (const double indentation : indentations)
    for (const double rate : rates) visit(indentation, rate);
}

}  // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(slopes_agree_with_differences, L, Laws) {
  const auto law = Sample<L>::law();
  for_each_state([&](double d, double w) {
    const auto f = force(law, d, w);
    const double h = 1e-5 * d, g = 1e-5;
    if (force(law, d - h, w - g).value == 0) return;  // the kink where the force is cut off
    const double by_indentation = (force(law, d + h, w).value - force(law, d - h, w).value) / (2 * h);
    const double by_rate = (force(law, d, w + g).value - force(law, d, w - g).value) / (2 * g);
    BOOST_TEST(std::abs(f.by_indentation - by_indentation) <= 1e-7 * (1 + std::abs(by_indentation)));
    BOOST_TEST(std::abs(f.by_rate - by_rate) <= 1e-7 * (1 + std::abs(by_rate)));
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_contact_never_pulls, L, Laws) {
  for_each_state([](double d, double w) { BOOST_TEST(force(Sample<L>::law(), d, w).value >= 0); });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(force_is_zero_at_first_touch_without_approach, L, Laws) {
  BOOST_TEST(force(Sample<L>::law(), 0, 0).value == 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(stored_energy_is_the_integral_of_the_static_force, L, Laws) {
  const auto law = Sample<L>::law();
  for (const double d : indentations) {
    const double h = 1e-5 * d;
    const double slope = (stored_energy(law, d + h) - stored_energy(law, d - h)) / (2 * h);
    BOOST_TEST(slope == force(law, d, 0).value, boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(damping_never_gives_energy, L, Laws) {
  const auto law = Sample<L>::law();
  for_each_state([&](double d, double w) {
    const double lost = (force(law, d, w).value - force(law, d, 0).value) * w;
    BOOST_TEST(lost >= 0);
    BOOST_TEST((damping(law) == 0) == (lost == 0 && force(law, d, 1).value == force(law, d, 0).value));
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_law_chosen_at_run_time_is_the_same_law, L, Laws) {
  const auto law = Sample<L>::law();
  const Law any = law;
  for_each_state([&](double d, double w) { BOOST_TEST(force(any, d, w).value == force(law, d, w).value); });
  BOOST_TEST(stiffness(any) == law.stiffness);
  BOOST_TEST(exponent(any) == exponent(law));
  BOOST_TEST(damping(any) == damping(law));
}

BOOST_AUTO_TEST_CASE(viscoelastic_force_is_zero_in_a_withdrawing_contact) {
  const Viscoelastic law{.stiffness = 1, .damping = 2, .exponent = 1.5};
  BOOST_TEST(force(law, 0.1, -1).value == 0);
  BOOST_TEST(force(law, 0.1, -0.04).value > 0);
}

BOOST_AUTO_TEST_CASE(viscoelastic_without_damping_is_linear_or_hertz) {
  BOOST_TEST(force(Viscoelastic{.stiffness = 2, .damping = 0, .exponent = 1}, 0.3, 1).value ==
             force(Linear{2}, 0.3, 1).value);
  BOOST_TEST(force(Viscoelastic{.stiffness = 2, .damping = 0, .exponent = 1.5}, 0.3, 1).value ==
                 force(Hertz{2}, 0.3, 1).value,
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(hertz_stiffness_of_two_equal_spheres) {
  // (4/3) · E/(2(1−ν²)) · √(R/2)
  const Material steel{.young = 210e9, .poisson = 0.3};
  const double expected = 4.0 / 3.0 * 210e9 / (2 * (1 - 0.09)) * std::sqrt(0.005);
  BOOST_TEST(hertz_stiffness(steel, 0.01, steel, 0.01) == expected, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(hertz_stiffness_against_a_rigid_plane) {
  const Material glass{.young = 48e9, .poisson = 0.2}, rigid{.young = HUGE_VAL, .poisson = 0};
  const double expected = 4.0 / 3.0 * 48e9 / (1 - 0.04) * std::sqrt(0.01);
  BOOST_TEST(hertz_stiffness(glass, 0.01, rigid, HUGE_VAL) == expected, boost::test_tools::tolerance(1e-14));
}
