// What the comments of apps/scenes say about long chains, about balls on cloth, and about a coin, a block and
// a dumbbell.
#define BOOST_TEST_MODULE example scenes
#include <boost/test/unit_test.hpp>
#include <numeric>

#include "mariotte/impact/bodies/bodies_impact.hpp"
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

impact::BodiesImpact run_bodies(const std::string& name) {
  const auto scene = scene::read(std::string(MARIOTTE_SCENES "/") + name);
  const auto impact = impact::simulate(std::get<model::Bodies>(scene.model), scene.run);
  const auto& energy = impact.energy;
  BOOST_TEST(std::abs(energy.residual) < 1e-8 * (energy.initial + std::abs(energy.work)));
  BOOST_TEST(impact.estimated_accuracy.value_or(0) < impact.requested_accuracy);
  for (const auto& contact : impact.contacts)
    for (const auto loss : impact::each_loss) BOOST_TEST((contact.losses.*loss >= 0));
  return impact;
}

/// Velocity at the lowest point of a billiard ball.
Vector3 slip(const Vector3& velocity, const Vector3& spin) {
  return velocity + cross(spin, {0, 0, -0.0286});
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

BOOST_AUTO_TEST_CASE(a_ball_that_curves_loses_two_sevenths_of_its_first_slip) {
  const auto impact = run_bodies("masse.toml");
  const auto& ball = impact.body[0];
  const Vector3 start{2, 0, 0}, first = slip(start, {-80, -40, 0});
  BOOST_TEST(norm(ball.velocity - (start - (2.0 / 7) * first)) < 1e-7);
  BOOST_TEST(norm(slip(ball.velocity, ball.spin)) < 1e-7);
  const double rolls = 2 * norm(first) / (7 * 0.2 * 9.81);
  BOOST_TEST(impact.events.back().of(model::BodyEvent::stick).size() == 1u);
  BOOST_TEST(std::abs(impact.events.back().time - rolls) < 1e-4 * rolls);
}

BOOST_AUTO_TEST_CASE(a_draw_shot_comes_back_and_the_other_ball_hops) {
  const auto impact = run_bodies("draw_shot.toml");
  BOOST_TEST(impact.body[0].velocity.e1 < -0.25);
  BOOST_TEST(impact.body[1].velocity.e1 > 0.5);
  for (const auto& body : impact.body) BOOST_TEST(norm(slip(body.velocity, body.spin)) < 1e-6);
  BOOST_TEST(impact.contacts[1].periods.size() == 2u);
}

// The edge of a disc has m/5 behind it. So without friction, gravity and thickness an impact at v with
// restitution e throws the other edge down with v (1 + 3 (1 + e)/5).
BOOST_AUTO_TEST_CASE(a_coin_slaps_down_nearly_twice_as_fast_clatters_and_lies_flat) {
  const auto impact = run_bodies("coin.toml");
  const auto &first = impact.contacts[0], &other = impact.contacts[1];
  const double v = *first.meeting.approach, e = *first.meeting.separation / v;
  BOOST_TEST(std::abs(*other.meeting.approach / v - (1 + 0.6 * (1 + e))) < 0.05);
  BOOST_TEST(*other.meeting.approach > 1.85 * v);
  for (const auto& contact : impact.contacts) {
    BOOST_TEST(contact.periods.size() > 10u);
    BOOST_TEST(!contact.periods.back().end.has_value());
  }
  BOOST_TEST(std::abs(impact.body[0].angle) < 1e-6);
  BOOST_TEST(impact.energy.final < 1e-6 * impact.energy.losses.total());
}

// With corners that hardly bounce. Housner (1963) lets them stop dead without slip: then the turning rate
// falls by 1 − (3/2) sin²α, where tan α is the ratio of the sides.
BOOST_AUTO_TEST_CASE(a_rocking_block_keeps_of_each_swing_what_housner_says) {
  auto scene = scene::read(MARIOTTE_SCENES "/rocking_with_friction.toml");
  auto& bodies = std::get<model::Bodies>(scene.model);
  for (auto& contact : bodies.contact) {
    contact.law = contact::Viscoelastic{.stiffness = 4e6, .damping = 4000, .exponent = 1};
    contact.tangential.stiffness = 3.2e6;
  }
  scene.run.max_time = 0.95;
  const auto trace = impact::simulate(bodies, scene.run, {.trace = true}).trace;
  const double slope = std::atan(1.0 / 3), housner = std::pow(1 - 1.5 * std::pow(std::sin(slope), 2), 2);
  const auto lift = [&](double angle) { return std::cos(slope - std::abs(angle)) - std::cos(slope); };
  std::vector<double> height{lift(bodies.body[0].angle)};
  for (std::size_t i = 1; i < trace.body.size(); ++i) {
    const auto &before = trace.body[i - 1][0], &now = trace.body[i][0];
    if (before.spin.e3 * now.spin.e3 < 0 && std::abs(now.angle) > 0.02) height.push_back(lift(now.angle));
  }
  BOOST_TEST_REQUIRE(height.size() > 3u);
  for (std::size_t i = 1; i < height.size(); ++i)
    BOOST_TEST(std::abs(height[i] / height[i - 1] - housner) < 0.005);
}

BOOST_AUTO_TEST_CASE(a_belt_pays_for_the_height_that_a_dumbbell_climbs) {
  const auto impact = run_bodies("climbing_dumbbell.toml");
  const double height = impact.body[0].position.e2, mass = 2 * impact.energy.initial / (0.8 * 0.8);
  double belt = 0;
  for (const auto& contact : impact.contacts) {
    const bool at_wall = contact.between[0] == "wall";
    if (at_wall) BOOST_TEST(contact.tangential_impulse.e1 == 0);
    belt += at_wall ? 0 : contact.tangential_impulse.e1 * 1;  // it runs with 1 m/s
  }
  const auto& energy = impact.energy;
  const double gain = energy.final - energy.initial + mass * 9.81 * height;
  BOOST_TEST(height > 0.4);
  BOOST_TEST(std::abs(belt - gain - energy.losses.total()) < 1e-8 * belt);
}
