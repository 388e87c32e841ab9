// What the comments of apps/scenes say about long chains.
#define BOOST_TEST_MODULE example scenes
#include <boost/test/unit_test.hpp>
#include <numeric>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/scene/scene.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

impact::ChainImpact run(const std::string& name) {
  const auto scene = scene::read(std::string(MARIOTTE_SCENES "/") + name);
  const auto impact = impact::simulate(std::get<model::Chain>(scene.model), scene.run);
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-8 * (impact.energy.initial + impact.energy.work));
  return impact;
}

/// The most periods of any contact.
std::size_t most_periods(const impact::ChainImpact& impact) {
  const auto counts = period_counts(impact);
  return *std::max_element(counts.begin(), counts.end());
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_solitary_wave_is_all_that_moves) {
  const auto impact = run("solitary_wave.toml");
  BOOST_TEST(impact.events.size() == 1000u);
  BOOST_TEST(most_periods(impact) == 1u);
  BOOST_TEST(impact.skipped.front().what == "balls at rest or in free flight");
  const auto& v = impact.velocity;
  const double caught = std::inner_product(v.end() - 20, v.end(), v.end() - 20, 0.0);
  BOOST_TEST(std::abs(caught - 0.993661007529) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_heavy_striker_sends_a_train_of_waves_that_throws_off_ball_after_ball) {
  const auto v = run("heavy_striker.toml").velocity;
  for (std::size_t i = v.size() - 10; i < v.size(); ++i) BOOST_TEST(v[i - 1] < 0.98 * v[i]);
  BOOST_TEST(v.back() > 2 * 0.9856788571);  // more than a ball of their own mass at twice the speed makes
}

BOOST_AUTO_TEST_CASE(colliding_waves_mirror_each_other) {
  const auto v = run("colliding_waves.toml").velocity;
  BOOST_TEST(std::abs(v[0] + v[199]) < 1e-9);
  BOOST_TEST(v[199] > 0.99);
}

BOOST_AUTO_TEST_CASE(a_tapered_chain_ends_fast_and_keeps_energy_back) {
  const auto impact = run("tapered_chain.toml");
  BOOST_TEST(most_periods(impact) == 1u);
  BOOST_TEST(impact.velocity.back() > 4);
  const double lightest = std::pow(0.94, 3 * 19);
  BOOST_TEST(lightest * impact.velocity.back() * impact.velocity.back() < 0.7);
}

BOOST_AUTO_TEST_CASE(light_balls_of_a_decorated_chain_rattle) {
  const auto impact = run("decorated_chain.toml");
  BOOST_TEST(most_periods(impact) > 10u);
  BOOST_TEST(impact.velocity.back() < 0.95);
}

BOOST_AUTO_TEST_CASE(a_column_falls_in_closed_form_and_rebounds_lower_than_a_bead) {
  const auto impact = run("column_on_a_wall.toml");
  const double landed = std::sqrt(2 * 9.81 * 5e-3);
  const double centre = std::accumulate(impact.velocity.begin(), impact.velocity.end(), 0.0) / 5;
  BOOST_TEST(std::abs(centre / landed - 0.930370) < 1e-3);  // of a column without gravity
  BOOST_TEST(impact.contacts[0].periods.size() == 1u);
  BOOST_TEST(std::abs(impact.contacts[0].periods[0].start - landed / 9.81) < 1e-9);
}
