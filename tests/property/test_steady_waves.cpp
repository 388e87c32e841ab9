// A wave that is moved on does what it does where every ball is followed.
#define BOOST_TEST_MODULE steady_waves
#include <boost/test/unit_test.hpp>
#include <random>

#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

constexpr std::size_t balls = 300;

bool is_moved_on(const impact::ChainImpact& impact) {
  const auto says = [](const auto& skipped) { return skipped.what == "steady waves"; };
  return std::any_of(impact.skipped.begin(), impact.skipped.end(), says);
}

impact::ChainImpact followed(const model::Chain& chain, double accuracy, double max_time = infinity) {
  return impact::simulate(chain, {.accuracy = accuracy, .max_time = max_time, .flow = flow::Kind::taylor});
}

double largest_peak_difference(const impact::ChainImpact& a, const impact::ChainImpact& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.contacts.size(); ++j)
    largest = std::max(largest, std::abs(a.contacts[j].peak_force - b.contacts[j].peak_force));
  return largest;
}

void expect_same(const model::Chain& chain, double accuracy, bool moves_on, double max_time = infinity) {
  const auto reference = followed(chain, 1e-13, max_time), same = followed(chain, accuracy, max_time);
  const auto impact = impact::simulate(chain, {.accuracy = accuracy, .max_time = max_time});
  const double own = difference(same.velocity, reference.velocity);
  BOOST_TEST(!is_moved_on(reference));
  BOOST_TEST(is_moved_on(impact) == moves_on);
  BOOST_TEST(impact.message == reference.message);
  BOOST_TEST((impact.ending == reference.ending));
  BOOST_TEST(difference(impact.velocity, reference.velocity) < std::max(accuracy, own));
  BOOST_TEST(difference(impulses(impact), impulses(reference)) < 10 * accuracy);
  BOOST_TEST(largest_peak_difference(impact, reference) < 10 * accuracy);
  BOOST_TEST((!moves_on || max_time < infinity || period_counts(impact) == period_counts(reference)));
  const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
  BOOST_TEST(std::is_sorted(impact.events.begin(), impact.events.end(), earlier));
}

model::Chain struck(double exponent = 1.5) {
  auto chain = equal_chain(balls);
  for (auto& law : chain.law) law = contact::Viscoelastic{1, 0, exponent};
  return chain;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_wave_is_moved_on_whatever_the_accuracy_and_the_exponent) {
  for (const double exponent : {1.5, 2.0, 3.0})
    for (const double accuracy : {1e-6, 1e-8, 1e-10, 1e-12})
      BOOST_TEST_CONTEXT("exponent " << exponent << ", accuracy " << accuracy)
  expect_same(struck(exponent), accuracy, true);
}

BOOST_AUTO_TEST_CASE(a_wave_that_goes_the_other_way_is_moved_on) {
  auto chain = struck();
  chain.velocity.front() = 0;
  chain.velocity.back() = -1;
  expect_same(chain, 1e-10, true);
}

// Later, whatever the flow, errors grow: balls that a wave has left rattle hundreds of times.
BOOST_AUTO_TEST_CASE(a_wave_comes_back_from_a_wall) {
  auto chain = struck();
  chain.mass.back() = infinity;
  expect_same(chain, 1e-10, true, 400);
}

BOOST_AUTO_TEST_CASE(a_wave_passes_what_is_different_in_the_row_ball_by_ball) {
  auto heavy = struck(), gap = struck(), stiff = struck(), moving = struck();
  heavy.mass[200] = 3;
  gap.gap[180] = 0.1;
  stiff.law[220] = contact::Hertz{2};
  moving.velocity[250] = -1e-3;
  for (const auto& chain : {heavy, gap, stiff}) expect_same(chain, 1e-10, true, 340);
  expect_same(moving, 1e-10, false, 100);  // it has waves of its own
}

BOOST_AUTO_TEST_CASE(a_run_ends_at_its_time_limit_with_the_wave_on_its_way) {
  expect_same(struck(), 1e-10, true, 150);
}

BOOST_AUTO_TEST_CASE(a_wave_stops_where_something_comes_towards_it) {
  auto chain = struck();
  chain.velocity.back() = -0.2;
  chain.gap.back() = 50;  // it arrives before the wave
  expect_same(chain, 1e-10, true, 320);
}

BOOST_AUTO_TEST_CASE(waves_of_damped_and_linear_and_uneven_rows_are_followed) {
  auto damped = struck(), uneven = struck(), alternating = struck();
  for (auto& law : damped.law) law = contact::Viscoelastic{1, 1e-12, 1.5};
  for (std::size_t i = 0; i < balls; i += 7) uneven.mass[i] = 1 + 1e-9;
  expect_same(damped, 1e-10, false);
  expect_same(uneven, 1e-10, false);
  for (std::size_t i = 1; i < balls; i += 2) alternating.mass[i] = 1 + 1e-8;  // its wave leaves motion behind
  expect_same(alternating, 1e-10, false, 280);
  expect_same(struck(1), 1e-8, false, 20);
}

BOOST_AUTO_TEST_CASE(light_strikers_of_any_speed_send_waves_that_are_moved_on) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> decade(-0.5, 0.0);
  constexpr double accuracy = 1e-10;
  for (int i = 0; i < 6; ++i) {
    auto chain = struck();
    chain.mass[0] = std::pow(10, decade(random));
    const double speed = chain.velocity[0] = std::pow(10, 4 * decade(random));
    const auto impact = impact::simulate(chain, {.accuracy = accuracy});
    const auto reference = followed(chain, 1e-13);
    BOOST_TEST_CONTEXT("mass " << chain.mass[0] << ", velocity " << speed) {
      BOOST_TEST(is_moved_on(impact));
      BOOST_TEST(difference(impact.velocity, reference.velocity) < accuracy * speed);
      BOOST_TEST((period_counts(impact) == period_counts(reference)));
    }
  }
}

// The second wave stays close behind the first for a long time.
BOOST_AUTO_TEST_CASE(two_strikers_send_two_waves) {
  auto chain = struck();
  chain.velocity[1] = 1;
  for (const double mass : {1.0, 0.9, 0.5}) {
    chain.mass[0] = mass;
    expect_same(chain, 1e-10, false, 200);
  }
}
