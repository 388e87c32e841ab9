#define BOOST_TEST_MODULE core_quantity
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "mariotte/core/quantity.hpp"
#include "mariotte/core/types.hpp"

namespace {

using namespace mariotte;

constexpr Dimension kelvin_voigt{.kg = 1, .m = -0.5, .s = -1};  // N s/m^1.5

struct Sample {
  std::string text;
  double value;
  Dimension dimension;
};

std::string complaint(const std::string& text, const Dimension& expected = dimension::none) {
  try {
    parse_quantity(text, expected);
  } catch (const QuantityError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_unit_scales_to_si) {
  const std::vector<Sample> samples{
      {"10 mm", 0.01, dimension::length},
      {"7 mm", 0.007, dimension::length},
      {"2.45 um", 2.45e-6, dimension::length},
      {"2.45 \u00b5m", 2.45e-6, dimension::length},
      {"2.45 \u03bcm", 2.45e-6, dimension::length},
      {"3 cm", 0.03, dimension::length},
      {"12 nm", 12e-9, dimension::length},
      {"210 GPa", 210e9, dimension::pressure},
      {"210 MPa", 210e6, dimension::pressure},
      {"5 kPa", 5e3, dimension::pressure},
      {"1.5 bar", 1.5e5, dimension::pressure},
      {"7800 kg/m^3", 7800, dimension::density},
      {"7.8 g/cm^3", 7800, dimension::density},
      {"25 g", 0.025, dimension::mass},
      {"3 mg", 3e-6, dimension::mass},
      {"2 t", 2000, dimension::mass},
      {"100 ns", 100e-9, dimension::time},
      {"2 min", 120, dimension::time},
      {"90 km/h", 25, dimension::velocity},
      {"9.81 m/s^2", 9.81, dimension::acceleration},
      {"9.81 m/s/s", 9.81, dimension::acceleration},
      {"2 rad/s", 2, {.s = -1}},
      {"50 Hz", 50, {.s = -1}},
      {"0.0105 s/m", 0.0105, {.m = -1, .s = 1}},
      {"0.38 J/m^2", 0.38, {.kg = 1, .s = -2}},
      {"0.38 J/m²", 0.38, {.kg = 1, .s = -2}},
      {"1e5 N/m", 1e5, dimension::stiffness(1)},
      {"1 kN", 1000, dimension::stiffness(0)},
  };
  for (const auto& [text, value, dimension] : samples) {
    const auto quantity = parse_quantity(text);
    // The number and the scaling are each rounded once.
    BOOST_TEST(std::abs(quantity.value - value) <= epsilon * value, text << " gave " << quantity.value);
    BOOST_TEST(same(quantity.dimension, dimension), text);
  }
}

BOOST_AUTO_TEST_CASE(whole_numbers_scale_to_the_double_of_the_literal) {
  BOOST_TEST(parse_quantity("7 mm").value == 0.007);
  BOOST_TEST(parse_quantity("25 g").value == 0.025);
  BOOST_TEST(parse_quantity("100 ns").value == 100e-9);
}

BOOST_AUTO_TEST_CASE(powers_may_be_fractions) {
  for (const auto* text : {"3 N/m^1.5", "3 N/m^(3/2)", "3 N m^-1.5", "3 N m^(-3/2)", "3 N/(m m^0.5)"}) {
    const auto quantity = parse_quantity(text);
    BOOST_TEST(quantity.value == 3, text);
    BOOST_TEST(same(quantity.dimension, dimension::stiffness(1.5)), text);
  }
  BOOST_TEST(std::abs(parse_quantity("1 N/mm^1.5").value / std::pow(1e3, 1.5) - 1) < 1e-15);
}

BOOST_AUTO_TEST_CASE(products_may_be_written_with_blank_star_or_dot) {
  for (const auto* text : {"1 N s/m^1.5", "1 N*s/m^1.5", "1 N·s/m^1.5", "1 N * s / m^(3/2)", "1N s/m^1.5"})
    BOOST_TEST(same(parse_quantity(text).dimension, kelvin_voigt), text);
}

BOOST_AUTO_TEST_CASE(a_product_after_a_division_must_be_in_parentheses) {
  BOOST_TEST(complaint("1 J/m^2 s").starts_with("ambiguous unit 'J/m^2 s'"));
  BOOST_TEST(same(parse_quantity("1 J/(m^2 s)").dimension, {.kg = 1, .s = -3}));
}

BOOST_AUTO_TEST_CASE(degrees_become_radians) {
  BOOST_TEST(std::abs(parse_quantity("45 deg").value - std::numbers::pi / 4) < 1e-15);
  BOOST_TEST(std::abs(parse_quantity("180°").value - std::numbers::pi) < 1e-15);
  BOOST_TEST(parse_quantity("5 mrad").value == 5e-3);
}

BOOST_AUTO_TEST_CASE(a_bare_number_is_si_of_any_dimension) {
  BOOST_TEST(parse_quantity("0.25", dimension::length) == 0.25);
  BOOST_TEST(parse_quantity(" -2e-3 ", dimension::density) == -2e-3);
  BOOST_TEST(parse_quantity("+3", dimension::none) == 3);
}

BOOST_AUTO_TEST_CASE(infinity_is_a_bare_number) {
  BOOST_TEST(std::isinf(parse_quantity("inf", dimension::mass)));
  BOOST_TEST(parse_quantity("-inf", dimension::mass) < 0);
  BOOST_TEST(complaint("inf kg", dimension::mass) != "accepted");
}

BOOST_AUTO_TEST_CASE(an_unknown_unit_comes_with_the_nearest_known_one) {
  BOOST_TEST(complaint("1 Gpa") == "unknown unit 'Gpa' (did you mean 'GPa'?)");
  BOOST_TEST(complaint("1 mmm") == "unknown unit 'mmm' (did you mean 'mm'?)");
  BOOST_TEST(complaint("1 Kg") == "unknown unit 'Kg' (did you mean 'kg'?)");
  BOOST_TEST(complaint("1 degs") == "unknown unit 'degs' (did you mean 'deg'?)");
  BOOST_TEST(complaint("1 furlongs") == "unknown unit 'furlongs'");
}

BOOST_AUTO_TEST_CASE(a_wrong_dimension_names_what_was_expected) {
  BOOST_TEST(complaint("1 kg", dimension::length) == "expected a length (m), got 'kg'");
  BOOST_TEST(complaint("1 N/m", dimension::stiffness(1.5)) == "expected a stiffness (N/m^1.5), got 'N/m'");
  BOOST_TEST(complaint("1 m", dimension::damping(2)) == "expected a damping (N s/m^2), got 'm'");
  BOOST_TEST(complaint("1 m", {.m = 3, .s = 0.5}) == "expected a quantity in m^3 s^0.5, got 'm'");
  BOOST_TEST(complaint("1 m", dimension::none) == "expected a plain number, got 'm'");
}

BOOST_AUTO_TEST_CASE(what_is_no_quantity_is_an_error) {
  for (const auto* text : {"",
                           " ",
                           "mm",
                           "ten mm",
                           "1 m^",
                           "1 m^^2",
                           "1 m^(2",
                           "1 m^2/",
                           "1 (m",
                           "1 m)",
                           "1 *m",
                           "1 m*",
                           "nan",
                           "1e999",
                           "--1",
                           "+-1",
                           "1 m^x",
                           "1 10",
                           "1 m^(1/0)",
                           "1 m^99",
                           "1 ((((((((((m))))))))))",
                           "infinity",
                           "0x10",
                           "1 \xff",
                           "1 mm^16^2",
                           "1 ((m^16)^16)^16)",
                           "1 ((Gm^16)^16)^16"})
    BOOST_TEST(complaint(text) != "accepted", text);
}

BOOST_AUTO_TEST_CASE(a_dimension_has_a_unit) {
  BOOST_TEST(unit_of(dimension::none) == "1");
  BOOST_TEST(unit_of(dimension::density) == "kg/m^3");
  BOOST_TEST(unit_of(dimension::stiffness(1.5)) == "N/m^1.5");
  BOOST_TEST(unit_of(dimension::damping(1.25)) == "N s/m^1.25");
  BOOST_TEST(unit_of({.kg = 2, .m = 1}) == "kg^2 m");
  for (const auto& one : {dimension::length, dimension::stiffness(1.5), dimension::damping(2)})
    BOOST_TEST(same(parse_quantity("1 " + unit_of(one)).dimension, one));
}
