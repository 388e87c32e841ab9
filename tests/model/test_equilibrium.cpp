#define BOOST_TEST_MODULE model_equilibrium
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/stated_law.hpp"
#include "mariotte/contact/thornton.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/model/chain/equilibrium.hpp"

using namespace mariotte;
using boost::test_tools::tolerance;

namespace {

/// Balls of different mass on a wall, the wall first; gravity towards it.
model::Chain column(double gravity = 9.81) {
  return {.mass = {infinity, 3, 2, 1},
          .law = {contact::Hertz(1e9), contact::Hertz(2e9), contact::Hertz(3e9)},
          .gap = {0, 0, 0},
          .velocity = {0, 0, 0, 0},
          .gravity = gravity};
}

model::Chain mirrored(model::Chain chain) {
  for (auto* values : {&chain.mass, &chain.gap, &chain.velocity})
    std::reverse(values->begin(), values->end());
  std::reverse(chain.law.begin(), chain.law.end());
  chain.gravity = -chain.gravity;
  return chain;
}

/// One ball between two walls.
model::Chain held(double force) {
  model::Chain chain{.mass = {infinity, 0.5, infinity},
                     .law = {contact::Hertz(1e8), contact::Hertz(1e8)},
                     .gap = {0, 0},
                     .velocity = {0, 0, 0}};
  put_at_rest(chain, force);
  return chain;
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_contact_of_a_column_carries_the_weight_above_it) {
  auto chain = column();
  put_at_rest(chain);
  const double weight[] = {6 * 9.81, 3 * 9.81, 1 * 9.81}, stiffness[] = {1e9, 2e9, 3e9};
  for (int j = 0; j < 3; ++j)
    BOOST_TEST(chain.gap[j] == -std::pow(weight[j] / stiffness[j], 2.0 / 3), tolerance(1e-14));
  BOOST_TEST(chain.precompressed);
}

BOOST_AUTO_TEST_CASE(a_column_under_its_wall_s_mirror_image_is_the_mirror_image) {
  auto chain = column(), image = mirrored(column());
  put_at_rest(chain);
  put_at_rest(image);
  BOOST_TEST(mirrored(image).gap == chain.gap, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(any_law_carries_its_force) {
  auto chain = column();
  chain.law = {contact::Linear(1e6), contact::Viscoelastic{1e9, 10, 1.2},
               std::make_shared<contact::HuntCrossley>(1e9, 0.1)};
  put_at_rest(chain);
  const auto force = static_forces(column());
  for (int j = 0; j < 3; ++j)
    BOOST_TEST(contact::force(chain.law[j], -chain.gap[j], 0).value == force[j], tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_row_at_rest_stays_at_rest) {
  auto chain = column();
  put_at_rest(chain);
  const auto impact = impact::simulate(chain, {.max_time = 1e-2});
  BOOST_TEST((impact.ending == hybrid::Ending::time_limit));
  for (const double velocity : impact.velocity) BOOST_TEST(std::abs(velocity) < 1e-9);  // falling: 0.1 m/s
}

// δ_y + (m g − f_y)/(πp_y R): beyond its elastic part.
BOOST_AUTO_TEST_CASE(a_contact_that_yields_under_the_weight_carries_it) {
  const contact::Thornton law(1e6, 0.01, 1e4);
  model::Chain chain{
      .mass = {infinity, 1}, .law = {contact::state(law)}, .gap = {0}, .velocity = {0, 0}, .gravity = 9.81};
  put_at_rest(chain, 0);
  BOOST_TEST(-chain.gap[0] == law.limit() + (9.81 - law.yield_force()) / law.slope(), tolerance(1e-12));
  const auto impact = impact::simulate(chain, {.max_time = 0.05});
  BOOST_TEST(std::abs(impact.velocity[1]) < 1e-9);
  BOOST_TEST(impact.contacts[0].peak_force == 9.81, tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(what_has_no_wall_below_it_falls_and_weighs_nothing) {
  auto chain = column();
  chain.gap[1] = 1e-3;  // the two upper balls fall
  put_at_rest(chain);
  BOOST_TEST(chain.gap[0] == -std::pow(3 * 9.81 / 1e9, 2.0 / 3), tolerance(1e-14));
  BOOST_TEST(chain.gap[1] == 1e-3);
  BOOST_TEST(chain.gap[2] == 0);
  const auto hanging = static_forces(column(-9.81));  // away from the wall
  BOOST_TEST(hanging == std::vector<double>(3, 0.0), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(walls_in_the_row_take_the_weight_above_them) {
  model::Chain chain{.mass = {infinity, 1, infinity, 2},
                     .law = std::vector<contact::Law>(3, contact::Hertz(1e8)),
                     .gap = {0, 0, 0},
                     .velocity = {0, 0, 0, 0},
                     .gravity = 10};
  BOOST_TEST(static_forces(chain) == (std::vector<double>{10, 0, 20}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(precompression_is_the_force_of_every_contact) {
  BOOST_TEST(held(100).gap == std::vector<double>(2, -std::pow(100 / 1e8, 2.0 / 3)),
             tolerance(1e-14) << boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_precompressed_ball_oscillates_at_the_tangent_stiffness) {
  // ω² = 2 K/m, K = (3/2) k^{2/3} F^{1/3}; by symmetry the next term is of second order in the amplitude
  auto chain = held(100);
  const double stiffness = 1.5 * std::pow(1e8, 2.0 / 3) * std::cbrt(100.0);
  const double frequency = std::sqrt(2 * stiffness / 0.5);
  chain.velocity[1] = 1e-4 * frequency * -chain.gap[0];  // an amplitude of 10⁻⁴ of the indentation
  const auto quarter = impact::simulate(chain, {.max_time = 0.5 * std::numbers::pi / frequency});
  const auto half = impact::simulate(chain, {.max_time = std::numbers::pi / frequency});
  BOOST_TEST(std::abs(quarter.velocity[1]) < 1e-6 * chain.velocity[1]);
  BOOST_TEST(half.velocity[1] == -chain.velocity[1], tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(a_precompression_that_nothing_holds_is_refused) {
  auto chain = column(0);
  BOOST_CHECK_THROW(put_at_rest(chain, 1), InvalidParameter);
  auto open = held(1);
  open.gap[0] = 1e-6;
  BOOST_CHECK_THROW(put_at_rest(open, 1), InvalidParameter);
  auto negative = held(1);
  BOOST_CHECK_THROW(put_at_rest(negative, -1), InvalidParameter);
}
