#define BOOST_TEST_MODULE report_number
#include <boost/test/unit_test.hpp>
#include <vector>

#include "mariotte/report/number.hpp"

using mariotte::report::display_for;
using mariotte::report::exact;
using mariotte::report::fixed;
using mariotte::report::rounded;
using mariotte::report::shown;

namespace {

std::string shown_alone(double value, const std::string& unit) {
  const auto display = display_for(std::vector{value}, unit);
  return shown(display, value) + " " + display.unit;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_text_gives_back_the_double) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 123456789.123456789, -2.5})
    BOOST_TEST(std::stod(exact(value)) == value);
}

BOOST_AUTO_TEST_CASE(ordinary_magnitudes_need_no_prefix) {
  BOOST_TEST(shown_alone(0.25, "m/s") == "0.25000000 m/s");
  BOOST_TEST(shown_alone(1, "m/s") == "1.0000000 m/s");
  BOOST_TEST(shown_alone(-1234.5, "N") == "-1234.5000 N");
}

BOOST_AUTO_TEST_CASE(small_and_large_magnitudes_get_an_engineering_prefix) {
  BOOST_TEST(shown_alone(5.6e-5, "s") == "56.000000 µs");
  BOOST_TEST(shown_alone(3.463e-8, "m") == "34.630000 nm");
  BOOST_TEST(shown_alone(2.5e4, "N") == "25.000000 kN");
  BOOST_TEST(shown_alone(1e-3, "J") == "1.0000000 mJ");
}

BOOST_AUTO_TEST_CASE(only_units_that_take_a_prefix_get_one) {
  BOOST_TEST(shown_alone(1e-5, "m^2") == "0.00001000 m^2");
  BOOST_TEST(shown_alone(2e-5, "1/s") == "0.00002000 1/s");
  BOOST_TEST(shown_alone(2e-5, "kg") == "20.000000 mg");
  BOOST_TEST(shown_alone(2, "kg") == "2.0000000 kg");
  BOOST_TEST(shown_alone(3e6, "N/m^1.5") == "3.0000000 MN/m^1.5");
}

BOOST_AUTO_TEST_CASE(there_are_no_kiloseconds) {
  BOOST_TEST(shown_alone(123456, "s") == "123456.00 s");
}

BOOST_AUTO_TEST_CASE(zero_is_shown_without_a_sign) {
  const auto display = display_for(std::vector{1.0, -0.0}, "m/s");
  BOOST_TEST(shown(display, -0.0) == "0.0000000");
}

BOOST_AUTO_TEST_CASE(no_text_of_a_number_has_a_zero_with_a_sign) {
  BOOST_TEST(exact(-0.0) == "0");
  BOOST_TEST(rounded(-0.0, 8) == "0");
  BOOST_TEST(fixed(-0.0, 3) == "0.000");
  BOOST_TEST(fixed(-1e-9, 3) == "0.000");
  BOOST_TEST(fixed(-1e-3, 3) == "-0.001");
}

BOOST_AUTO_TEST_CASE(a_value_too_small_for_its_column_is_not_shown_as_zero) {
  const auto display = display_for(std::vector{1.0}, "m/s");
  BOOST_TEST(shown(display, -3e-12) == "-3.00e-12");
}

BOOST_AUTO_TEST_CASE(values_that_are_not_finite_do_not_spoil_a_column) {
  const auto display = display_for(std::vector{1.0, std::numeric_limits<double>::infinity()}, "m");
  BOOST_TEST(shown(display, 1.0) == "1.0000000");
  BOOST_TEST(shown(display, std::numeric_limits<double>::infinity()) == "inf");
}
