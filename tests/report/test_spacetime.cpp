#define BOOST_TEST_MODULE spacetime
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/report/figure/spacetime.hpp"

using namespace mariotte;

namespace {

/// Feeds samples for as long as they are wanted; velocity = time. Returns how many were taken.
int feed(report::Spacetime& image, double crossing_time, double end) {
  const auto sampling = image.sampling();
  impact::Sample sample{.natural_time = 1, .crossing_time = crossing_time};
  int taken = 0;
  for (double time = 0; time < end; ++taken) {
    sample.time = time;
    sample.velocity.assign(sampling.velocities.size(), time);
    time += sampling.take(sample);
  }
  return taken;
}

/// The velocities of the first ball, which are times here.
std::vector<double> first_ball(const std::string& matrix) {
  std::vector<double> values;
  for (auto at = matrix.find('\n') + 1; at < matrix.size(); at = matrix.find('\n', at) + 1)
    values.push_back(std::stod(matrix.substr(matrix.find(',', at) + 1)));
  return values;
}

}  // namespace

BOOST_AUTO_TEST_CASE(balls_of_a_very_long_chain_are_evenly_spaced) {
  report::Spacetime image(10001);
  const auto balls = image.sampling().velocities;
  BOOST_TEST(balls.size() <= 500u);
  for (std::size_t i = 0; i < balls.size(); ++i) BOOST_TEST(balls[i] == 21 * static_cast<Index>(i));
  BOOST_TEST(report::Spacetime(60).sampling().velocities.size() == 60u);
}

BOOST_AUTO_TEST_CASE(rows_stay_evenly_spaced_and_few) {
  report::Spacetime image(60);
  feed(image, 1e5, 3e5);
  const auto times = first_ball(image.data());
  BOOST_TEST(times.size() <= 1000u);
  BOOST_TEST(times.size() > 500u);
  const double interval = times[1] - times[0];
  for (std::size_t i = 0; i < times.size(); ++i)
    BOOST_TEST(std::abs(times[i] - static_cast<double>(i) * interval) < 1e-5 * 3e5);
}

BOOST_AUTO_TEST_CASE(what_comes_after_the_waves_is_not_in_the_image) {
  report::Spacetime image(60);
  feed(image, 50, 1e9);
  BOOST_TEST(first_ball(image.data()).back() <= 200);
}

BOOST_AUTO_TEST_CASE(two_samples_make_no_image) {
  report::Spacetime image(60);
  feed(image, 100, 0.3);
  BOOST_TEST(!image.is_image());
}

BOOST_AUTO_TEST_CASE(the_script_draws_what_the_data_hold) {
  report::Spacetime image(1200);
  feed(image, 100, 100);
  const auto script = image.script("It's a wave");
  BOOST_TEST(script.find("'It''s a wave'") != std::string::npos);
  BOOST_TEST(script.find("plot 'spacetime.csv' nonuniform matrix with image") != std::string::npos);
  const auto data = image.data();
  BOOST_TEST(data.starts_with("time [s],1,4,7,"));
  BOOST_TEST(data.find(",1198\n0,0,0,") != std::string::npos);
  BOOST_TEST(data.find("\n0.25,0.25,0.25,") != std::string::npos);
  BOOST_TEST(script.find("spacetime.png") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(samples_that_come_anew_make_the_image_alone) {
  report::Spacetime image(3), other(3);
  feed(image, 25, 50);
  image.sampling().restart();
  feed(image, 100, 50);
  feed(other, 100, 50);
  BOOST_TEST(image.data() == other.data());
}
