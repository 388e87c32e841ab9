#define BOOST_TEST_MODULE report_axis_names
#include <boost/test/unit_test.hpp>

#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/ticks.hpp"

using namespace mariotte::report;

BOOST_AUTO_TEST_CASE(results_have_words_and_a_symbol_with_numbers_from_1) {
  BOOST_TEST(name_of_result("icr[0]", "α_j") == "impulse correlation ratio α_{1}");
  BOOST_TEST(name_of_result("final.velocity[2]", "v_i") == "final velocity v_{3}");
  BOOST_TEST(name_of_result("final.velocity", "v_i") == "final velocity v_i");
  BOOST_TEST(name_of_result("contacts[1].peak_force", "max f_n") == "peak force max f_{n,2}");
  BOOST_TEST(name_of_result("final.bodies[1].velocity[0]", "v") == "final velocity v_{2,1}");
  BOOST_TEST(name_of_result("restitution.tip", "e_n") == "tip restitution e_n");
  BOOST_TEST(name_of_result("restitution.centre", "e_nm") == "centre restitution e_{nm}");
  BOOST_TEST(name_of_result("events.count", "") == "number of events");
  BOOST_TEST(name_of_result("energy.friction", "") == "friction energy");
  BOOST_TEST(name_of_result("contacts[1].stored", "") == "stored 2");
}

BOOST_AUTO_TEST_CASE(places_from_the_end_are_n_and_before) {
  BOOST_TEST(name_of_result("final.velocity[-1]", "v_i") == "final velocity v_{n}");
  BOOST_TEST(name_of_result("contacts[-2].peak_force", "max f_n") == "peak force max f_{n,n−1}");
  BOOST_TEST(name_of_result("contacts[-1].peak_force", "max f_j") == "peak force max f_{n−1}");
  BOOST_TEST(name_of_result("icr[-2]", "α_j") == "impulse correlation ratio α_{n−3}");
  BOOST_TEST(name_of_result("energy.ratio_lab", "T⁺/T⁻") == "energy ratio T⁺/T⁻");
}

BOOST_AUTO_TEST_CASE(a_legend_has_symbols_or_words_for_want_of_one) {
  BOOST_TEST(short_name_of_result("final.velocity[2]", "v_i") == "v_{3}");
  BOOST_TEST(short_name_of_result("contacts[1].stored", "") == "stored 2");
}

BOOST_AUTO_TEST_CASE(inputs_have_words_and_a_symbol_with_numbers_from_1) {
  BOOST_TEST(name_of_input("chain.gap[1]") == "gap g_{2}");
  BOOST_TEST(name_of_input("chain.contact[1].stiffness") == "stiffness k_{2}");
  BOOST_TEST(name_of_input("chain.material.young") == "Young's modulus E");
  BOOST_TEST(name_of_input("incidence.angles[1]") == "angle β");
  BOOST_TEST(name_of_input("chain.velocity[0]") == "initial velocity v_{1}^{−}");
  BOOST_TEST(name_of_input("body.length_ratio") == "length ratio");
}

BOOST_AUTO_TEST_CASE(slopes_are_quotients_of_symbols) {
  BOOST_TEST(name_of_slope("sensitivity.velocity[2].mass[0]") == "∂v_{3}/∂m_{1}");
  BOOST_TEST(name_of_slope("sensitivity.time.contact[1].stiffness") == "∂t/∂k_{2}");
  BOOST_TEST(name_of_slope("sensitivity.icr[0].gravity") == "∂α_{1}/∂gravity");
}

BOOST_AUTO_TEST_CASE(numbers_have_a_minus_that_is_no_hyphen) {
  BOOST_TEST(tick_name(-0.4) == "−0.4");
  BOOST_TEST(tick_name(1e-6) == "1e-06");
  BOOST_TEST(tick_name(0) == "0");
}

BOOST_AUTO_TEST_CASE(a_logarithmic_axis_has_as_many_ticks_as_have_room) {
  using Ticks = std::vector<double>;
  const auto are = [](const Ticks& found, const Ticks& expected) {
    BOOST_TEST(found == expected, boost::test_tools::tolerance(1e-12) << boost::test_tools::per_element());
  };
  are(logarithmic_ticks(1, 10, 44), {1, 2, 3, 5, 7, 10});
  are(logarithmic_ticks(1, 100, 34), {1, 2, 5, 10, 20, 50, 100});
  are(logarithmic_ticks(0.001, 0.5, 34), {0.001, 0.003, 0.01, 0.03, 0.1, 0.3});
  are(logarithmic_ticks(1e-3, 1e3, 34), {1e-3, 1e-2, 1e-1, 1, 10, 100, 1000});
  are(logarithmic_ticks(2.1, 2.9, 34), {2.2, 2.4, 2.6, 2.8});
  are(logarithmic_ticks(1e-12, 1e3, 30), {1e-12, 1e-9, 1e-6, 1e-3, 1, 1000});
}

BOOST_AUTO_TEST_CASE(names_of_greek_letters_are_letters) {
  BOOST_TEST(greek("kappa") == "κ");
  BOOST_TEST(greek("alpha_12") == "α_{12}");
  BOOST_TEST(greek("my_ratio") == "my\\_ratio");
}

BOOST_AUTO_TEST_CASE(units_stand_in_brackets_with_their_powers_raised) {
  BOOST_TEST(with_unit("k", "N/m^1.5") == "k\u00a0[N/m^{1.5}]");
  BOOST_TEST(with_unit("c", "N s^2/m^1.5 s") == "c\u00a0[N s^{2}/m^{1.5} s]");
  BOOST_TEST(with_unit("α", "1") == "α");
  BOOST_TEST(plain("a_b^c") == "a\\_b\\^c");
}

BOOST_AUTO_TEST_CASE(ticks_stand_at_round_numbers_and_are_not_too_many) {
  BOOST_TEST(tick_step(0.2, 5) == 0.05, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(tick_step(100, 10) == 10, boost::test_tools::tolerance(1e-12));
}
