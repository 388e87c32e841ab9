#define BOOST_TEST_MODULE driven speeds
// How exact what is driven is, whatever its signal would do to a free body, or does after the end.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/driven_rows.hpp"

using namespace mariotte;
using namespace mariotte::test;
using impact::simulate;
using model::Driven;
using std::numbers::pi;

// What counts of a signal is what comes before the end, and how fast it makes bodies that contacts hold.
BOOST_AUTO_TEST_CASE(what_a_signal_does_after_the_end_does_not_matter) {
  const auto pushed = [](double last, double accuracy) {
    const auto force = model::straight_lines({{0, 0}, {1, -0.01}, {2, -0.01}, {last, -0.01}});
    auto row = row_behind_wall({contact::Hertz(1), contact::Hertz(1)}, drive(2, Driven::force, force));
    return simulate(row, until(30, accuracy)).velocity;
  };
  const auto walled = [](double last, double accuracy) {
    const auto motion = model::straight_lines({{0, 0}, {1, 0.01}, {40, 0.01}, {last, 1e6}});
    return simulate(
               row_behind_wall({contact::Hertz(1), contact::Hertz(1)}, drive(0, Driven::velocity, motion)),
               until(30, accuracy))
        .velocity;
  };
  for (const double accuracy : {1e-4, 1e-8}) {
    const auto soon = pushed(31, accuracy), walled_soon = walled(41, accuracy);
    const auto exact = pushed(31, 1e-12), walled_exact = walled(41, 1e-12);
    for (const double last : {1e3, 1e9}) {
      BOOST_TEST(pushed(last, accuracy) == soon, boost::test_tools::per_element());
      BOOST_TEST(walled(last, accuracy) == walled_soon, boost::test_tools::per_element());
    }
    for (std::size_t i = 1; i < 3; ++i) {
      BOOST_TEST(std::abs(soon[i] - exact[i]) < 0.1 * accuracy);
      BOOST_TEST(std::abs(walled_soon[i] - walled_exact[i]) < 0.1 * accuracy);
    }
  }
}

// A hundred seconds of a force that a contact holds would make a free ball a thousand times as fast.
BOOST_AUTO_TEST_CASE(a_force_that_grows_slowly_moves_a_ball_as_its_stiffness_says) {
  const double frequency = 2 * pi * 1e-5, force = 10;
  auto row =
      row_behind_wall({contact::Linear(4)}, drive(1, Driven::force, model::sine(-force, frequency, 0)));
  // m ẍ + k x = −F sin ω t from rest.
  const double natural = 2, amplitude = -force / (natural * natural - frequency * frequency);
  const auto velocity = [&](double t) {
    return amplitude * frequency * (std::cos(frequency * t) - std::cos(natural * t));
  };
  for (const double accuracy : {1e-4, 1e-7}) {
    const auto solved = simulate(row, until(100, accuracy));
    BOOST_TEST(std::abs(solved.velocity[1] - velocity(100)) < accuracy * std::abs(amplitude) * frequency * 2);
    impact::ChainSolver solver;
    BOOST_TEST(std::abs(solver.solve(row, until(100, accuracy)).velocity[1] - velocity(100)) <
               accuracy * std::abs(amplitude) * frequency * 2);
  }
}

// Lanes of a network begin with what pushes: here with its second contact. A ball has two behind it.
BOOST_AUTO_TEST_CASE(series_of_driven_networks_agree_with_cvode_whichever_contacts_are_open) {
  const model::Network network{.mass = {infinity, 1, 1, 1},
                               .direction = {{{0, -1}, {1, 1}}, {{1, -1}, {2, 1}}, {{1, -1}, {3, 1}}},
                               .law = {contact::Hertz(1), contact::Hertz(2), contact::Hertz(1.5)},
                               .gap = {0.3, 0, 0.1},
                               .velocity = {0, 0, 0, 0},
                               .drive = {drive(0, Driven::velocity, model::sine(1, 0.7, 0)),
                                         drive(2, Driven::force, model::sine(-0.2, 0.4, 1))}};
  auto by_cvode = until(20, 1e-12);
  by_cvode.flow = flow::Kind::cvode_adams;
  const auto exact = simulate(network, by_cvode), found = simulate(network, until(20));
  BOOST_TEST(found.flows.front().name == "taylor");
  for (std::size_t i = 0; i < 4; ++i) BOOST_TEST(std::abs(found.velocity[i] - exact.velocity[i]) < 1e-9);
  BOOST_TEST(std::abs(found.energy.residual) < 1e-9);
}
