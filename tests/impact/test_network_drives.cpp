#define BOOST_TEST_MODULE impact network drives
// Forces that act on networks, as a function of time says.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/impact/network/network_impact.hpp"
#include "support/driven_rows.hpp"

using namespace mariotte;
using namespace mariotte::test;
using impact::simulate;
using model::Driven;
using std::numbers::pi;

/// Two dofs, a full mass matrix, one force: M v̇ = Gᵀf + w F.
BOOST_AUTO_TEST_CASE(a_force_pushes_a_network_by_its_mass_matrix) {
  model::Network network{.mass = {2, 0.5, 0.5, 1},
                         .direction = {{{0, -1}, {1, 1}}},
                         .law = {contact::Hertz(1)},
                         .gap = {5},
                         .velocity = {0, 0}};
  network.drive = {{.direction = {{0, 1.0}}, .quantity = Driven::force, .signal = model::half_sine(1, 1)}};
  const auto impact = simulate(network, until(1.5));
  const double impulse = 2 / pi, determinant = 2 * 1 - 0.25;
  BOOST_TEST(impact.velocity[0] == impulse / determinant, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(impact.velocity[1] == -0.5 * impulse / determinant, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(impact.energy.work == 0.5 * impulse * impulse / determinant, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(impact.momentum_residual < 1e-10);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-10);
}

// Within one step of a series a force presses what touches and draws it apart again.
// By a dense matrix rounding moves the wall, too.
BOOST_AUTO_TEST_CASE(every_flow_pushes_a_ball_on_a_wall_of_a_network) {
  model::Network network{.mass = {infinity, 4e-3},
                         .direction = {{{0, -1}, {1, 1}}},
                         .law = {contact::Hertz(4e10)},
                         .gap = {0},
                         .velocity = {0, 0}};
  network.drive = {{.direction = {{1, 1.0}},
                    .quantity = Driven::force,
                    .signal = model::straight_lines({{0, 700}, {2e-5, 500}})}};
  const auto best = simulate(network, until(1.3e-4));
  for (const auto kind : {flow::Kind::cvode_adams, flow::Kind::cvode_bdf_dense, flow::Kind::cvode_bdf_band,
                          flow::Kind::cvode_bdf_klu}) {
    auto options = until(1.3e-4);
    options.flow = kind;
    const auto impact = simulate(network, options);
    BOOST_TEST((impact.ending == hybrid::Ending::time_limit), impact.message);
    BOOST_TEST(std::abs(impact.velocity[0]) < 1e-20);
    BOOST_TEST(impact.velocity[1] == best.velocity[1], boost::test_tools::tolerance(1e-8));
  }
}

// The contacts of such a network are a row; what is driven stands beside it.
BOOST_AUTO_TEST_CASE(what_is_driven_need_not_be_in_a_contact) {
  for (const Index driven : {0, 1, 2}) {
    const Index left = driven == 0, right = driven == 2 ? 1 : 2;
    model::Network network{.mass = {1, 1, 1},
                           .direction = {{{left, -1}, {right, 1}}},
                           .law = {contact::Hertz(1000)},
                           .gap = {0.1},
                           .velocity = {0, 0, 0}};
    network.velocity[static_cast<std::size_t>(right)] = 1;
    network.drive = {
        {.direction = {{driven, 1.0}}, .quantity = Driven::force, .signal = model::half_sine(1, 1)}};
    const auto impact = simulate(network, until(2));
    BOOST_TEST((impact.ending == hybrid::Ending::time_limit), impact.message);
    BOOST_TEST(impact.velocity[static_cast<std::size_t>(driven)] == 2 / pi,
               boost::test_tools::tolerance(1e-10));
    BOOST_TEST(impact.energy.work == 2 / (pi * pi), boost::test_tools::tolerance(1e-9));
    BOOST_TEST(std::abs(impact.energy.residual) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(the_momenta_of_what_no_contact_moves_balance) {
  model::Network network{.mass = {1, 1, infinity},
                         .direction = {{{1, 1}, {2, 1}}},
                         .law = {contact::PowerLaw{1, 0, 1}},
                         .gap = {1},
                         .velocity = {0, 0, 0.5}};
  for (const double end : {3.0, 10.0}) {  // a part of a period, and a whole one
    network.drive = {
        {.direction = {{0, 1.0}}, .quantity = Driven::force, .signal = model::sine(1, 0.2 * pi, 0)}};
    const auto impact = simulate(network, until(end));
    BOOST_TEST((impact.ending == hybrid::Ending::time_limit), impact.message);
    BOOST_TEST(std::abs(impact.velocity[0] - (1 - std::cos(0.2 * pi * end)) / (0.2 * pi)) < 1e-9);
  }
}
