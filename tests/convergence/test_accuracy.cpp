// The accuracy knob means the error of the final velocities.
#define BOOST_TEST_MODULE accuracy
#include <boost/test/unit_test.hpp>

#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

const char* const flows[] = {"cvode-adams", "cvode-bdf-dense", "cvode-bdf-band", "cvode-bdf-klu"};

/// Error and right-hand sides of the touching triplet of equal Hertz balls at one accuracy.
struct Point {
  double error;
  double rhs;
};

Point measure(const std::string& flow, double accuracy) {
  static const Numbers exact = {-7.095235365143687e-02, 7.640303907120699e-02, 9.945493145802298e-01};
  const auto impact =
      impact::simulate(equal_chain(3), {.accuracy = accuracy, .flow = flow::parse_kind(flow)});
  Point point{difference(impact.velocity, exact), 0};
  for (const auto& use : impact.flows) point.rhs += static_cast<double>(use.rhs);
  return point;
}

double slope(double x0, double y0, double x1, double y1) {
  return std::log(y1 / y0) / std::log(x1 / x0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(asked_is_got_from_1e_minus_3_to_1e_minus_10) {
  for (const auto* flow : flows)
    for (int decade = 3; decade <= 10; ++decade) BOOST_TEST_CONTEXT(flow << " at 1e-" << decade)
  BOOST_TEST(measure(flow, std::pow(10.0, -decade)).error <= std::pow(10.0, -decade));
}

BOOST_AUTO_TEST_CASE(the_error_falls_in_proportion_to_the_accuracy_asked) {
  for (const auto* flow : flows) {
    const auto loose = measure(flow, 1e-4), tight = measure(flow, 1e-10);
    BOOST_TEST_CONTEXT(flow << " " << loose.error << " " << tight.error) {
      const double order = slope(1e-4, loose.error, 1e-10, tight.error);
      BOOST_TEST(order > 0.7);
      BOOST_TEST(order < 1.3);
    }
  }
}

BOOST_AUTO_TEST_CASE(work_grows_as_the_order_of_the_method_says) {
  // Work ~ error^{−1/p}: BDF runs at order 5 at most, Adams up to 12 though not on such short phases.
  for (const auto* flow : flows) {
    const auto loose = measure(flow, 1e-6), tight = measure(flow, 1e-10);
    const double order = -1 / slope(loose.error, loose.rhs, tight.error, tight.rhs);
    BOOST_TEST_CONTEXT(flow << " order " << order) {
      BOOST_TEST(order > (std::string(flow) == "cvode-adams" ? 5.0 : 3.5));
      BOOST_TEST(order < (std::string(flow) == "cvode-adams" ? 14.0 : 7.0));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_estimate_is_close_to_the_true_error) {
  for (const auto& c : cases("triplets.json")) {
    const auto chain = triplet(c);
    const hybrid::Options options{.accuracy = 1e-6};
    const auto impact = impact::simulate(chain, options);
    const double error = difference(impact.velocity, c.at("final"));
    const double estimate = impact::estimate_accuracy(chain, options, impact);
    BOOST_TEST_CONTEXT(c.at("law") << " kappa " << c.at("kappa") << " velocity " << c.at("velocity")) {
      BOOST_TEST(estimate >= 0.8 * error - 1e-15);  // closed forms have none to estimate
      BOOST_TEST(estimate < 1.2 * error + 1e-9);
    }
  }
}
