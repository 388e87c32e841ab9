#define BOOST_TEST_MODULE model signal
// Functions of time that drives prescribe.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/core/types.hpp"
#include "mariotte/model/drives/signal.hpp"

using namespace mariotte;
using namespace mariotte::model;

namespace {

double at(const Signal& signal, double time) {
  return value(signal.piece[piece_at(signal, time)], time);
}

Signal some_signals(int which) {
  const std::vector<SignalPoint> points = {{0, 1}, {0.4, -1}, {1, 2}, {1.5, 2}, {2, 5}};
  if (which == 0) return sine(2, 3, 0.4);
  if (which == 1) return half_sine(1.5, 1.3);
  return which == 2 ? straight_lines(points) : smooth_curve(points);
}

}  // namespace

BOOST_AUTO_TEST_CASE(rates_and_integrals_are_those_of_the_values) {
  for (int which = 0; which < 4; ++which) {
    const auto signal = some_signals(which);
    const double h = 1e-5;
    for (double t = 0.05; t < 3; t += 0.17) {
      BOOST_TEST(std::abs(at(rate(signal), t) - (at(signal, t + h) - at(signal, t - h)) / (2 * h)) < 1e-7);
      BOOST_TEST(std::abs(at(signal, t) - (integral(signal, t + h) - integral(signal, t - h)) / (2 * h)) <
                 1e-7);
    }
  }
}

BOOST_AUTO_TEST_CASE(curves_pass_through_their_points_and_no_further) {
  for (const int which : {2, 3}) {
    const auto signal = some_signals(which);
    BOOST_TEST(at(signal, 0.4) == -1);
    BOOST_TEST(at(signal, 1.25) == 2, boost::test_tools::tolerance(1e-14));  // monotone: flat between equals
    BOOST_TEST(at(signal, 9) == 5);
    for (double t = 0; t < 2; t += 0.01) BOOST_TEST((at(signal, t) >= -1 && at(signal, t) <= 5));
  }
}

BOOST_AUTO_TEST_CASE(other_units_change_numbers_only) {
  for (int which = 0; which < 4; ++which) {
    const auto signal = some_signals(which), other = scaled(signal, 0.1, 7);
    for (double t = 0; t < 3; t += 0.13) {
      BOOST_TEST(std::abs(at(other, t / 0.1) * 7 - at(signal, t)) < 1e-13);
      BOOST_TEST(std::abs(integral(other, t / 0.1) * 0.7 - integral(signal, t)) < 1e-13);
    }
    BOOST_TEST(largest(other, infinity) * 7 == largest(signal, infinity),
               boost::test_tools::tolerance(1e-14));
  }
}
