#define BOOST_TEST_MODULE long chains
#include <boost/test/unit_test.hpp>

#include "support/long_chains.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// Reference values in extended precision of n touching equal balls, k = m = v₁ = 1: the ends of the chain do
/// not depend on n, and the last force ends so much later per ball.
constexpr double first_velocity = -0.0710850170860943, second_velocity = -0.0302737893644727;
constexpr double last_but_one_velocity = 0.148600463236243, last_velocity = 0.985678857090035;
constexpr double first_peak = 0.758420340911680, plateau_peak = 0.639554232124447,
                 last_peak = 0.624182774539055;
constexpr double end_of_100 = 119.228764299681853, per_ball = 1.189755576980284;
constexpr double leading_energy = 0.993661007529;

void check_ends(const Numbers& velocity, double allowed) {
  const std::size_t n = velocity.size();
  BOOST_TEST(std::abs(velocity[0] - first_velocity) < allowed);
  BOOST_TEST(std::abs(velocity[1] - second_velocity) < allowed);
  BOOST_TEST(std::abs(velocity[n - 2] - last_but_one_velocity) < allowed);
  BOOST_TEST(std::abs(velocity[n - 1] - last_velocity) < allowed);
}

}  // namespace

// Behind the wave velocities fall off like 0.45^i, below any accuracy after some 30 balls. What happens there
// must not show as events.
BOOST_AUTO_TEST_CASE(contacts_whose_motion_is_below_the_accuracy_make_no_events) {
  for (const std::size_t balls : {40u, 60u, 100u}) {
    for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
      const auto impact = impact::simulate(equal_chain(balls), {.accuracy = accuracy});
      BOOST_TEST_CONTEXT(balls << " balls at " << accuracy) {
        BOOST_TEST((impact.ending == hybrid::Ending::separated));
        BOOST_TEST(impact.events.size() == balls);
        for (const auto count : period_counts(impact)) BOOST_TEST(count == 1u);
        BOOST_TEST(std::abs(impact.energy.residual) < 100 * accuracy);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(long_chains_are_right_from_end_to_end) {
  for (const std::size_t n : {100u, 1000u}) {
    const auto impact = impact::simulate(equal_chain(n), {.accuracy = 1e-12});
    BOOST_TEST_CONTEXT(n << " balls") {
      check_ends(impact.velocity, 1e-10);
      BOOST_TEST(std::abs(impact.time - (end_of_100 + (static_cast<double>(n) - 100) * per_ball)) < 1e-8);
      BOOST_TEST(std::abs(impact.contacts[0].peak_force - first_peak) < 1e-10);
      BOOST_TEST(std::abs(impact.contacts[n / 2].peak_force - plateau_peak) < 1e-10);
      BOOST_TEST(std::abs(impact.contacts[n - 2].peak_force - last_peak) < 1e-10);
      double left_behind = 0;
      for (std::size_t i = 0; i < 50; ++i) left_behind += impact.velocity[i] * impact.velocity[i];
      BOOST_TEST(std::abs(1 - left_behind - leading_energy) < 1e-10);
    }
  }
}

// Steel, R = 10 mm, 1 m/s, E = 210 GPa, ν = 0.3, ρ = 7800 kg/m³; the wave passes 900 balls more.
BOOST_AUTO_TEST_CASE(a_wave_in_steel_has_the_reference_forces_and_speed) {
  constexpr double pi = 3.14159265358979323846, radius = 0.01, diameter = 2 * radius;
  Numbers ends;
  for (const std::size_t n : {100u, 1000u}) {
    auto chain = equal_chain(n);
    chain.mass.assign(n, 7800 * 4 * pi / 3 * std::pow(radius, 3));
    chain.law.assign(n - 1, contact::Hertz{210e9 * std::sqrt(2 * radius) / (3 * (1 - 0.3 * 0.3))});
    const auto impact = impact::simulate(chain, {.accuracy = 1e-12});
    BOOST_TEST(std::abs(impact.contacts[0].peak_force / 1007.044258 - 1) < 1e-9);
    BOOST_TEST(std::abs(impact.contacts[n / 2].peak_force / 849.211687 - 1) < 1e-9);
    ends.push_back(impact.time);
  }
  BOOST_TEST(std::abs(ends[0] / 2.93376733987e-3 - 1) < 1e-10);
  BOOST_TEST(std::abs(ends[1] / 29.2815993183e-3 - 1) < 1e-10);
  BOOST_TEST(std::abs(900 * diameter / (ends[1] - ends[0]) / 683.168164 - 1) < 1e-8);
}

BOOST_AUTO_TEST_CASE(ten_thousand_balls_end_like_a_hundred) {
  for (const double accuracy : {1e-8, 1e-12}) {
    const auto impact = impact::simulate(equal_chain(10000), {.accuracy = accuracy});
    check_ends(impact.velocity, accuracy);
    BOOST_TEST(impact.events.size() == 10000u);
    // the wave's speed, a tenth power of its energy, is right to a fraction of the accuracy all the way
    BOOST_TEST(std::abs(impact.time - (end_of_100 + 9900 * per_ball)) < 10000 * accuracy);
    BOOST_TEST(std::abs(impact.momentum.residual) < 1e-12);
  }
}

// Nesterenko's wave, by energy and by momentum; what it leaves behind are the first balls' rebounds.
BOOST_AUTO_TEST_CASE(the_leading_wave_has_the_momentum_and_the_energy_of_a_solitary_one) {
  const auto impact = impact::simulate(equal_chain(1000), {.accuracy = 1e-10, .max_time = 700});
  double energy = 0, momentum = 0;
  for (std::size_t i = 500; i < 1000; ++i) momentum += impact.velocity[i];
  for (std::size_t i = 0; i < 500; ++i) energy += impact.velocity[i] * impact.velocity[i];
  BOOST_TEST(std::abs(momentum - 1.138305) < 6e-7);
  BOOST_TEST(std::abs(1 - energy - leading_energy) < 1e-9);
  BOOST_TEST(std::abs(1 / per_ball / std::pow(plateau_peak, 1. / 6) - 0.905516) < 6e-7);
}

BOOST_AUTO_TEST_CASE(a_random_chain_of_ten_thousand_stops_where_it_is_told_with_closed_balances) {
  const auto chain = random_long_chain(10000);
  const auto impact = impact::simulate(chain, {.accuracy = 1e-8, .max_time = 500});
  BOOST_TEST((impact.ending == hybrid::Ending::time_limit));
  BOOST_TEST(std::abs(impact.time - 500) < 1e-12 * 500);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-6 * impact.energy.initial);
  BOOST_TEST(std::abs(impact.momentum.residual) < 1e-12 * impact.momentum.initial);
  for (std::size_t j = 0; j < impact.contacts.size(); ++j)
    if (impact.gap[j] < -1e-3) BOOST_TEST(!impact.contacts[j].periods.empty());
}

BOOST_AUTO_TEST_CASE(a_random_chain_comes_to_its_end) {
  const auto impact = impact::simulate(random_long_chain(200), {.accuracy = 1e-8});
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-6 * impact.energy.initial);
  for (std::size_t i = 0; i + 1 < impact.velocity.size(); ++i)
    BOOST_TEST(impact.velocity[i + 1] - impact.velocity[i] > -1e-8);
}
