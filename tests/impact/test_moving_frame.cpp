// Chains and networks that fly much faster than their balls move among themselves.
#define BOOST_TEST_MODULE impact_moving_frame
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/chain/chain_frame.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/network/network_frame.hpp"
#include "mariotte/impact/network/network_solver.hpp"
#include "support/reference.hpp"

using namespace mariotte;

namespace {

constexpr double common = 2048;

contact::Law law(double stiffness, double damping, double exponent) {
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = exponent};
}

/// Contact 2 creeps: the sign of its load is a matter of 10⁻¹² of the forces in it.
model::Chain creeping() {
  return {
      .mass = {1.0885916393508497, 1.2291756756521943, 1.1941651029635316, 0.77581213161883134},
      .law = {law(0.24333373436033162, 0, 1.7185683019076323), law(2.2151769740208338, 68756.555125297135, 3),
              law(3.2256745281283798, 17.916267839960138, 1)},
      .gap = {0, 0, 0},
      .velocity = {0.203125, -0.085937500, -0.03125, -0.0546875}};
}

model::Chain flying(model::Chain chain) {
  for (double& v : chain.velocity) v += common;
  return chain;
}

/// So fast that rounding of the common velocity is all that is left of the load of a contact that creeps.
constexpr double swift = 0x1p20;

/// Two rows of balls in a plane, struck aslant; all fly by at different speeds along the two axes.
model::Network flying_rack(double by) {
  const auto at = [by](double x, double y, double vx, double vy) {
    return model::Ball{.position = {x, y}, .velocity = {vx + by, vy - 0.5 * by}, .mass = 1, .radius = 0.5};
  };
  const auto damped = [](Index, Index) { return law(1, 1e4, 1.5); };
  return model::ball_network({at(0, 0, 0.25, 0), at(1, 0.25, -0.25, 0.125), at(1, -0.75, 0, 0)}, 0.1, damped);
}

}  // namespace

// To the accuracy of its own speeds, and not only to that of the common one.
BOOST_AUTO_TEST_CASE(a_chain_that_flies_does_what_it_does_at_rest) {
  const auto resting = creeping(), moving = flying(resting);
  for (const double accuracy : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto still = impact::simulate(resting, {.accuracy = accuracy});
    const auto fast = impact::simulate(moving, {.accuracy = accuracy});
    BOOST_TEST((fast.ending == hybrid::Ending::separated));
    BOOST_TEST(fast.events.size() == still.events.size());
    for (std::size_t i = 0; i < resting.mass.size(); ++i)
      BOOST_TEST(std::abs(fast.velocity[i] - (still.velocity[i] + common)) <=
                 0.2 * accuracy + 2 * epsilon * common);
    BOOST_TEST(std::abs(fast.energy.dissipated - still.energy.dissipated) < accuracy * still.energy.initial);
    BOOST_TEST(std::abs(*fast.energy.ratio_centre - *still.energy.ratio_centre) < accuracy);
  }
}

BOOST_AUTO_TEST_CASE(energy_and_momentum_are_those_of_the_flying_chain) {
  const auto chain = flying(creeping());
  const auto impact = impact::simulate(chain);
  double momentum = 0;
  for (std::size_t i = 0; i < chain.mass.size(); ++i) momentum += chain.mass[i] * chain.velocity[i];
  const double energy = kinetic_energy(chain, chain.velocity);
  BOOST_TEST(impact.energy.initial == energy, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(impact.energy.final == kinetic_energy(chain, impact.velocity));
  BOOST_TEST(*impact.energy.ratio_lab == impact.energy.final / energy, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-14 * energy);
  BOOST_TEST(impact.momentum.initial == momentum, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(impact.momentum.final == momentum, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(stored_energy_at_the_start_is_counted_once) {
  auto chain = flying(creeping());
  chain.precompressed = true;
  chain.gap[0] = -0.25;
  const auto impact = impact::simulate(chain);
  const double stored = contact::stored_energy(chain.law[0], 0.25);
  BOOST_TEST(impact.energy.initial == kinetic_energy(chain, chain.velocity) + stored,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(who_looks_on_is_told_velocities_from_outside) {
  const auto chain = flying(creeping());
  double least = common;
  impact::Sampling sampling{.velocities = {0, 1, 2, 3}, .take = [&](const impact::Sample& sample) {
                              for (const double v : sample.velocity) least = std::min(least, v);
                              return sample.natural_time;
                            }};
  impact::simulate(chain, {}, {.samplings = {sampling}});
  BOOST_TEST(least > common - 1);
  const auto traced = impact::simulate(chain, {}, {.trace = true});
  for (const auto& row : traced.trace.velocity)
    for (const double v : row) BOOST_TEST(std::abs(v - common) < 1);
}

BOOST_AUTO_TEST_CASE(the_brief_solver_agrees_and_goes_back_to_chains_at_rest) {
  impact::ChainSolver solver;
  const auto resting = creeping(), moving = flying(resting);
  const auto before = solver.solve(resting).velocity;
  BOOST_TEST(test::difference(solver.solve(moving).velocity, impact::simulate(moving).velocity) == 0);
  BOOST_TEST(test::difference(solver.solve(resting).velocity, before) == 0);
}

BOOST_AUTO_TEST_CASE(a_frame_is_left_only_where_nothing_tells_it_from_another) {
  const auto chain = flying(creeping());
  BOOST_TEST(impact::moving_frame(chain).at(3) == chain.velocity[0]);
  auto falling = chain, walled = chain, wide = chain;
  falling.gravity = 1;
  walled.mass[0] = infinity;
  wide.velocity[3] = 0;
  for (const auto& other : {falling, walled, wide, creeping()}) BOOST_TEST(!impact::moving_frame(other));
}

BOOST_AUTO_TEST_CASE(a_network_that_flies_does_what_it_does_at_rest) {
  auto chain = creeping();
  const auto resting = model::as_network(chain);
  for (double& v : chain.velocity) v += swift;
  const auto moving = model::as_network(chain);
  impact::NetworkSolver solver;
  for (const double accuracy : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto still = impact::simulate(resting, {.accuracy = accuracy});
    const auto quick = impact::simulate(moving, {.accuracy = accuracy});
    BOOST_TEST((quick.ending == hybrid::Ending::separated));
    BOOST_TEST(quick.events.size() == still.events.size());
    for (std::size_t i = 0; i < still.velocity.size(); ++i)
      BOOST_TEST(std::abs(quick.velocity[i] - (still.velocity[i] + swift)) <=
                 0.2 * accuracy + 2 * epsilon * swift);
    BOOST_TEST(std::abs(quick.energy.dissipated - still.energy.dissipated) < accuracy * still.energy.initial);
    BOOST_TEST(std::abs(*quick.energy.ratio_centre - *still.energy.ratio_centre) < accuracy);
    BOOST_TEST(test::difference(solver.solve(moving, {.accuracy = accuracy}).velocity, quick.velocity) == 0);
  }
}

BOOST_AUTO_TEST_CASE(balls_of_a_network_share_a_velocity_by_coordinate) {
  const auto still = impact::simulate(flying_rack(0)), quick = impact::simulate(flying_rack(swift));
  BOOST_TEST((quick.ending == hybrid::Ending::separated));
  BOOST_TEST(quick.events.size() == still.events.size());
  for (std::size_t i = 0; i < still.velocity.size(); ++i) {
    const double common_here = i % 2 == 0 ? swift : -0.5 * swift;
    BOOST_TEST(std::abs(quick.velocity[i] - (still.velocity[i] + common_here)) <= 2 * epsilon * swift);
  }
  const auto before = impact::configuration_of(flying_rack(swift));
  BOOST_TEST(quick.energy.initial == kinetic_energy(before, before.velocity));
  BOOST_TEST(quick.energy.final == kinetic_energy(before, quick.velocity));
}

BOOST_AUTO_TEST_CASE(who_looks_on_at_a_network_is_told_velocities_from_outside) {
  double least = swift;
  impact::Sampling sampling{.velocities = {0, 4}, .take = [&](const impact::Sample& sample) {
                              for (const double v : sample.velocity) least = std::min(least, v);
                              return sample.natural_time;
                            }};
  const auto network = flying_rack(swift);
  const auto traced = impact::simulate(network, {}, {.trace = true, .samplings = {sampling}});
  BOOST_TEST(least > swift - 1);
  for (const auto& row : traced.trace.velocity)
    for (std::size_t i = 0; i < row.size(); ++i)
      BOOST_TEST(std::abs(row[i] - (i % 2 == 0 ? swift : -0.5 * swift)) < 1);
}

BOOST_AUTO_TEST_CASE(a_network_is_left_where_it_is_if_gaps_or_walls_tell_its_velocity) {
  const auto network = flying_rack(swift);
  BOOST_TEST(impact::moving_frame(network).at(5) == network.velocity[1]);
  auto walled = network, turning = network;
  walled.mass[0] = walled.mass[1] = infinity;
  turning.direction[0].pop_back();
  for (const auto& other : {walled, turning, flying_rack(0)}) BOOST_TEST(!impact::moving_frame(other));
}
