#define BOOST_TEST_MODULE study_uncertainty
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/study/fit/uncertainty.hpp"

using namespace mariotte::study;

namespace {

/// Slopes of the residuals of a straight line a + b x at x = 0, 1, 2, 3.
const std::vector<double> line = {1, 1, 1, 1, 0, 1, 2, 3};

}  // namespace

// The textbook's: var b = 1 / Σ(x − x̄)², var a = 1/n + x̄² / Σ(x − x̄)², cov = −x̄ / Σ(x − x̄)².
BOOST_AUTO_TEST_CASE(a_straight_line_has_the_errors_of_the_closed_form) {
  const auto known = uncertainty(line, 2);
  const double a = std::sqrt(0.25 + 2.25 / 5), b = std::sqrt(1.0 / 5);
  BOOST_TEST(std::abs(known.standard_error[0] - a) < 1e-14);
  BOOST_TEST(std::abs(known.standard_error[1] - b) < 1e-14);
  BOOST_TEST(std::abs(known.correlation[0][1] + 1.5 / 5 / (a * b)) < 1e-14);
  BOOST_TEST(known.correlation[1][0] == known.correlation[0][1]);
  BOOST_TEST(known.correlation[1][1] == 1.0);
}

BOOST_AUTO_TEST_CASE(a_straight_line_is_determined) {
  BOOST_TEST(undetermined(line, 2, 1e-5).empty());
}

BOOST_AUTO_TEST_CASE(values_without_effect_are_undetermined_alone) {
  const auto directions = undetermined(std::vector<double>{1, 2, 3, 0, 0, 0}, 2, 1e-5);
  BOOST_TEST_REQUIRE(directions.size() == 1u);
  BOOST_TEST(std::abs(directions[0][0]) < 1e-12);
  BOOST_TEST(std::abs(directions[0][1]) == 1.0);
}

BOOST_AUTO_TEST_CASE(values_with_the_same_effect_are_undetermined_together) {
  const auto directions = undetermined(std::vector<double>{1, 2, 3, -2, -4, -6}, 2, 1e-5);
  BOOST_TEST_REQUIRE(directions.size() == 1u);
  BOOST_TEST(std::abs(directions[0][0] - 2 * directions[0][1]) < 1e-12);
}

BOOST_AUTO_TEST_CASE(without_any_effect_nothing_is_determined) {
  BOOST_TEST(undetermined(std::vector<double>(6, 0.0), 2, 1e-5).size() == 2u);
}

// Closed forms for one and two degrees of freedom; the third is from printed tables.
BOOST_AUTO_TEST_CASE(students_t_has_its_known_quantiles) {
  BOOST_TEST(std::abs(student_t(0.95, 1) - std::tan(0.475 * std::numbers::pi)) < 1e-10);
  BOOST_TEST(std::abs(student_t(0.95, 2) - 0.95 * std::sqrt(2 / (1 - 0.95 * 0.95))) < 1e-10);
  BOOST_TEST(std::abs(student_t(0.99, 10) - 3.169) < 5e-4);
}
