#define BOOST_TEST_MODULE network impact
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/laws/multiple_impact_law.hpp"
#include "mariotte/impact/network/network_balance.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/networks.hpp"
#include "support/random_chains.hpp"
#include "support/random_networks.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::impact;
using test::difference;
using test::Numbers;

namespace {

void check_balances(const NetworkImpact& impact, double allowed) {
  BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
  BOOST_TEST(std::abs(impact.energy.residual) < allowed * impact.energy.initial);
  BOOST_TEST(impact.momentum_residual < allowed);
}

/// No mass between rigid and wall, no gravity.
model::Chain plain_chain(std::mt19937_64& random, int i) {
  return test::random_chain(random, test::kinds[i % 2]);
}

/// Hertz contacts, and damped ones between them.
contact::Law mixed_law(std::mt19937_64& random, std::size_t j) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double k = 0.1 + unit(random);
  if (j % 2 == 0) return contact::Hertz{k};
  return contact::Viscoelastic{k, 0.3 * unit(random), 1.5};
}

}  // namespace

BOOST_AUTO_TEST_CASE(chains_written_as_networks_agree_with_the_chain_model) {
  std::mt19937_64 random(200);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const auto chain = plain_chain(random, i);
    const auto as_chain = simulate(chain, {.accuracy = 1e-14});
    const auto as_network = simulate(model::as_network(chain), {.accuracy = 1e-14});
    BOOST_TEST_CONTEXT("chain " << i) {
      BOOST_TEST((as_network.ending == hybrid::Ending::separated), as_network.message);
      BOOST_TEST(difference(as_network.velocity, as_chain.velocity) < 1e-12);
      BOOST_TEST(difference(impulses_of(as_network), test::impulses(as_chain)) < 1e-11);
      for (std::size_t j = 0; j < chain.law.size(); ++j)
        BOOST_TEST(as_network.contacts[j].periods.size() == as_chain.contacts[j].periods.size());
    }
    worst = std::max(worst, difference(as_network.velocity, as_chain.velocity));
  }
  BOOST_TEST_MESSAGE("worst difference of velocities " << worst);
}

// What touches at rest is pressed and drawn by turns. Contacts of high exponents are shallow for long.
BOOST_AUTO_TEST_CASE(a_contact_that_is_drawn_apart_a_little_keeps_its_gap) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 12; ++i) {
    auto network = test::rack(4, 0);
    for (auto& law : network.law)
      law = contact::Viscoelastic{0.3 + 3 * unit(random), 0, 1.2 + 1.2 * unit(random)};
    const auto exact = simulate(network, {.accuracy = 1e-13, .flow = flow::Kind::cvode_adams});
    BOOST_TEST(difference(simulate(network, {.accuracy = 1e-9}).velocity, exact.velocity) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(order_and_direction_of_a_row_do_not_matter) {
  auto network = model::as_network(test::equal_chain(4));
  const auto run = simulate(network, {.accuracy = 1e-13});
  std::swap(network.direction[0], network.direction[2]);
  for (auto& direction : network.direction) std::swap(direction[0], direction[1]);
  const auto other = simulate(network, {.accuracy = 1e-13});
  BOOST_TEST(difference(run.velocity, other.velocity) < 1e-14);
  BOOST_TEST(other.flows[0].name == run.flows[0].name);
}

// By symmetry both impulses are equal, so energy and momentum alone decide: (−1/5, 2√3/5 · 30°) [Bernoulli].
BOOST_AUTO_TEST_CASE(one_on_two_keeps_its_symmetry_to_rounding) {
  const auto run = simulate(test::one_on_two(), {.accuracy = 1e-12});
  check_balances(run, 1e-11);
  const auto& v = run.velocity;
  BOOST_TEST(std::abs(v[1]) <= epsilon);
  BOOST_TEST(std::abs(v[2] - v[4]) <= epsilon);
  BOOST_TEST(std::abs(v[3] + v[5]) <= epsilon);
  BOOST_TEST(std::abs(run.contacts[0].impulse - run.contacts[1].impulse) <= epsilon);
  BOOST_TEST(v[0] == -0.2, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(v[2] == 0.6, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(v[3] == std::sqrt(3.0) / 5, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(run.contacts[2].impulse == 0);  // the two part from each other
}

// A ball falls on three that touch each other: with c the cosine between its path and the lines of centres,
// symmetry, energy and momentum leave p = 2c/(1 + 3c²) and −(3c² − 1)/(1 + 3c²).
BOOST_AUTO_TEST_CASE(one_on_three_in_space_follows_from_energy_and_momentum) {
  const double cosine = std::sqrt(2.0 / 3), around = 1 / std::sqrt(3.0);
  const std::vector<model::Ball> balls = {{{0, 0, cosine}, {0, 0, -1}, 1, 0.5},
                                          {{around, 0, 0}, {0, 0, 0}, 1, 0.5},
                                          {{-around / 2, 0.5, 0}, {0, 0, 0}, 1, 0.5},
                                          {{-around / 2, -0.5, 0}, {0, 0, 0}, 1, 0.5}};
  const auto network = model::ball_network(balls, 0, test::hertz_of_pair);
  BOOST_REQUIRE(network.law.size() == 6U);
  const auto run = simulate(network, {.accuracy = 1e-12});
  check_balances(run, 1e-10);
  BOOST_TEST(run.velocity[2] == 1.0 / 3, boost::test_tools::tolerance(1e-9));
  for (int j = 0; j < 3; ++j) {
    BOOST_TEST(run.contacts[j].impulse == 2 * cosine / 3, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(run.contacts[j].peak_force == run.contacts[0].peak_force, boost::test_tools::tolerance(1e-9));
  }
  for (int j = 3; j < 6; ++j) BOOST_TEST(run.contacts[j].impulse == 0);
}

// Without friction the speed across the contact stays, for half a period of the spring.
BOOST_AUTO_TEST_CASE(a_direction_would_have_turned_by_what_balls_slide_past_each_other) {
  const double k = 1e6, distance = 0.02, across = 0.5;
  const std::vector<model::Ball> balls = {{{0, 0}, {1, across}, 1, 0.01}, {{distance, 0}, {0, 0}, 1, 0.01}};
  const auto network =
      model::ball_network(balls, 0, [&](Index, Index) -> contact::Law { return contact::Linear{k}; });
  const auto run = simulate(network, {.accuracy = 1e-10});
  const double duration = std::numbers::pi * std::sqrt(0.5 / k);
  BOOST_REQUIRE(run.turning.has_value());
  BOOST_TEST(*run.turning == std::atan(across * duration / distance), boost::test_tools::tolerance(1e-8));
  const model::Network other{.mass = {1, 1},
                             .direction = {{{0, -1}, {1, 1}}},
                             .law = {contact::Linear{k}},
                             .gap = {0},
                             .velocity = {1, 0}};
  BOOST_TEST(!simulate(other).turning.has_value());
}

// Heave and rocking of a block on two springs are its natural modes, as long as both are closed.
BOOST_AUTO_TEST_CASE(a_block_on_two_springs_moves_in_its_two_modes) {
  const double mass = 5, inertia = 0.06, half = 0.1, k = 1, heave = -1, spin = 2;
  const model::Network block{.mass = {mass, inertia},
                             .direction = {{{0, 1}, {1, -half}}, {{0, 1}, {1, half}}},
                             .law = {contact::Linear{k}, contact::Linear{k}},
                             .gap = {0, 0},
                             .velocity = {heave, spin}};
  const double up = std::sqrt(2 * k / mass), round = std::sqrt(2 * k * half * half / inertia);
  const auto gap = [&](double t, double side) {
    return heave * std::sin(up * t) / up + side * half * spin * std::sin(round * t) / round;
  };
  double low = 0.1 / round, high = 6;  // the right edge, less pressed, lets go first: bisect for its time
  while (gap(high, 1) < 0) high += 0.1;
  for (int i = 0; i < 100; ++i) (gap(0.5 * (low + high), 1) < 0 ? low : high) = 0.5 * (low + high);

  const auto run = simulate(block, {.accuracy = 1e-13});
  check_balances(run, 1e-11);
  BOOST_REQUIRE(run.contacts[1].periods.size() >= 1U);
  BOOST_TEST(std::abs(*run.contacts[1].periods[0].end - low) < 1e-10);
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_pulled_apart_at_once_never_closes) {
  const auto run = simulate(test::one_on_two());
  BOOST_TEST(run.contacts[2].periods.empty());
  BOOST_TEST(run.contacts[2].impulse == 0);
  BOOST_REQUIRE(run.events.size() == 2U);
  BOOST_TEST(run.events[0].close == (std::vector<Index>{0, 1}));
  BOOST_TEST(run.events[1].open == (std::vector<Index>{0, 1}));
}

// Both creep apart, so that their loads are rounding soon. What one lets go of does not hold the other.
BOOST_AUTO_TEST_CASE(overdamped_contacts_of_a_block_let_go_together_at_every_accuracy) {
  const double arm = 0.89601746834419327;
  model::Network block{
      .mass = {1, 0.42222562595496449},
      .direction = {{{0, 1}, {1, -arm}}, {{0, 1}, {1, arm}}},
      .law = {contact::Viscoelastic{
                  .stiffness = 0.88858454719719904, .damping = 3556.6108378424765, .exponent = 1},
              contact::Viscoelastic{
                  .stiffness = 1.2759386421481678, .damping = 6240.6727988712773, .exponent = 1}},
      .gap = {0, 0},
      .velocity = {-0.99090278641968932, -0.083020157905306702}};
  const auto exact = simulate(block, {.accuracy = 1e-12, .flow = flow::Kind::cvode_bdf_klu});
  for (const double accuracy : {1e-6, 1e-8, 1e-10, 1e-11, 1e-12}) {
    const auto run = simulate(block, {.accuracy = accuracy});
    BOOST_TEST(test::difference(run.velocity, exact.velocity) < 1e-13);
    BOOST_TEST(run.time < 0.01);
  }
}

// The last two balls of a triangle touch at rest, and the dampers of the others draw them apart.
BOOST_AUTO_TEST_CASE(strong_dampers_do_not_pull_at_what_they_draw_apart) {
  model::Network rack{.mass = {1.2, 1.2, 0.67, 0.67, 0.74, 0.74, 2.5, 2.5},
                      .direction = {{{0, -std::sqrt(0.75)}, {1, 0.5}, {2, std::sqrt(0.75)}, {3, -0.5}},
                                    {{0, -std::sqrt(0.75)}, {1, -0.5}, {4, std::sqrt(0.75)}, {5, 0.5}},
                                    {{0, 0.93}, {1, 0.37}, {6, -0.93}, {7, -0.37}},
                                    {{3, -1}, {5, 1}}},
                      .law = {},
                      .gap = {0, 0, 0, 0},
                      .velocity = {0, 0, 0, 0, 0, 0, 1, 0}};
  rack.law.assign(4, contact::Viscoelastic{.stiffness = 1, .damping = 76334.253263324805, .exponent = 1});
  const auto exact = simulate(rack, {.flow = flow::Kind::cvode_bdf_klu});
  for (const double accuracy : {1e-6, 1e-10, 1e-12}) {
    const auto run = simulate(rack, {.accuracy = accuracy});
    BOOST_TEST((run.ending == hybrid::Ending::separated), run.message);
    BOOST_TEST(run.contacts[3].impulse == 0);
    BOOST_TEST(test::difference(run.velocity, exact.velocity) < accuracy + 1e-10);
  }
}

// Dampers so strong that their contacts never leave the noise of indentations at 10⁻⁶.
BOOST_AUTO_TEST_CASE(a_damper_within_the_noise_does_not_pull_when_it_is_struck_again) {
  std::vector<model::Ball> balls;
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k <= row; ++k)
      balls.push_back(
          {.position = {row * std::sqrt(0.75), k - 0.5 * row}, .velocity = {0, 0}, .mass = 1, .radius = 0.5});
  balls.push_back({.position = {-0.92283372462122693, -0.38519854192573677},
                   .velocity = {1, -0.29710702013852752},
                   .mass = 0.63529938730301894,
                   .radius = 0.5});
  const auto rack = model::ball_network(balls, 0.2, [](Index i, Index j) -> contact::Law {
    if (j == 6 || (i == 1 && j == 2) || (i == 2 && j == 4)) return contact::Hertz{1};
    return contact::Viscoelastic{.stiffness = 1, .damping = 1664858.2671038467, .exponent = 1};
  });
  const auto exact = simulate(rack, {.accuracy = 1e-12, .max_time = 300});
  for (const double accuracy : {1e-6, 1e-8}) {
    const auto run = simulate(rack, {.accuracy = accuracy, .max_time = 300});
    BOOST_TEST((run.ending == hybrid::Ending::separated));
    BOOST_TEST(test::difference(run.velocity, exact.velocity) < accuracy);
  }
}

BOOST_AUTO_TEST_CASE(peaks_are_those_of_the_chain_model) {
  std::mt19937_64 random(201);
  for (int i = 0; i < 20; ++i) {
    const auto chain = plain_chain(random, i);
    const auto as_chain = simulate(chain, {.accuracy = 1e-12});
    const auto as_network = simulate(model::as_network(chain), {.accuracy = 1e-12}, {.trace = true});
    double force = 0, depth = 0;
    for (const auto& contact : as_chain.contacts) {
      force = std::max(force, contact.peak_force);
      depth = std::max(depth, contact.peak_indentation);
    }
    for (std::size_t j = 0; j < chain.law.size(); ++j) {
      const auto &a = as_chain.contacts[j], &b = as_network.contacts[j];
      BOOST_TEST(std::abs(a.peak_force - b.peak_force) <= 1e-9 * force);
      BOOST_TEST(std::abs(a.peak_indentation - b.peak_indentation) <= 1e-9 * depth);
    }
    BOOST_TEST(as_network.trace.velocity.back() == as_network.velocity);
  }
}

BOOST_AUTO_TEST_CASE(speeds_at_which_bodies_meet_and_part_are_those_of_the_chain_model) {
  std::mt19937_64 random(31);
  for (int i = 0; i < 20; ++i) {
    const auto chain = plain_chain(random, i);
    const auto as_chain = simulate(chain);
    const auto as_network = simulate(model::as_network(chain));
    for (std::size_t j = 0; j < chain.law.size(); ++j) {
      const auto &one = as_chain.contacts[j].meeting, &other = as_network.contacts[j].meeting;
      if (as_chain.contacts[j].periods.size() != as_network.contacts[j].periods.size()) continue;
      BOOST_TEST(std::abs(one.approach.value_or(-1) - other.approach.value_or(-1)) < 1e-7, i << " " << j);
      BOOST_TEST(std::abs(one.separation.value_or(-1) - other.separation.value_or(-1)) < 1e-7, i << " " << j);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_estimate_of_the_error_is_within_what_was_asked) {
  const auto network = test::rack(3, 0);
  const auto run = simulate(network, {.accuracy = 1e-8});
  const double estimate = estimate_accuracy(network, {.accuracy = 1e-8}, run);
  BOOST_TEST(estimate > 0);
  BOOST_TEST(estimate < 1e-8);
}

BOOST_AUTO_TEST_CASE(other_coordinates_give_the_same_impact) {
  // Bernoulli's problem in coordinates u with v = T u, T unit lower triangular: M = TᵀT is full.
  const auto plain = test::one_on_two();
  const Index n = 6;
  const auto t = [](Index i, Index j) { return i == j ? 1 : i > j ? 0.3 / static_cast<double>(i + j) : 0; };
  auto turned = plain;
  turned.mass.assign(n * n, 0.0);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      for (Index k = 0; k < n; ++k) turned.mass[n * i + j] += t(k, i) * t(k, j);
  for (std::size_t j = 0; j < plain.direction.size(); ++j) {
    turned.direction[j].clear();
    for (Index i = 0; i < n; ++i) {
      double coefficient = 0;
      for (const auto& term : plain.direction[j]) coefficient += term.coefficient * t(term.dof, i);
      turned.direction[j].push_back({i, coefficient});
    }
  }
  turned.velocity = plain.velocity;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < i; ++j) turned.velocity[i] -= t(i, j) * turned.velocity[j];
  const auto a = simulate(plain, {.accuracy = 1e-12}), b = simulate(turned, {.accuracy = 1e-12});
  Numbers back(n, 0.0);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j <= i; ++j) back[i] += t(i, j) * b.velocity[j];
  BOOST_TEST(difference(a.velocity, back) < 1e-9);
  BOOST_TEST(difference(impulses_of(a), impulses_of(b)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(random_networks_keep_energy_and_momentum) {
  std::mt19937_64 random(31);
  for (int i = 0; i < 60; ++i) {
    BOOST_TEST_CONTEXT("network " << i) {
      const auto network = test::random_network(random, mixed_law);
      const auto run = simulate(network);
      check_balances(run, 1e-8);
      for (const auto& contact : run.contacts) BOOST_TEST(contact.impulse >= 0);
      for (const double rate : gap_rates(configuration_of(network), run.velocity)) BOOST_TEST(rate > -1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(flows_agree_on_networks) {
  std::mt19937_64 random(32);
  const auto network = test::packing(3, 0.5, random);
  const auto adams = simulate(network, {.accuracy = 1e-10, .flow = flow::Kind::cvode_adams});
  for (const char* flow : {"cvode-bdf-dense", "cvode-bdf-klu"}) {
    const auto other = simulate(network, {.accuracy = 1e-10, .flow = flow::parse_kind(flow)});
    BOOST_TEST(difference(adams.velocity, other.velocity) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(simulated_networks_come_back_through_the_law) {
  const auto network = test::rack(4, 0);
  const auto run = simulate(network);
  const auto before = configuration_of(network);
  auto parameters = parameters_of(before, impulses_of(run), run.velocity);
  parameters.slow = 1e-9;
  const auto outcome = multiple_impact(before, parameters);
  BOOST_TEST((outcome.status == LawStatus::admissible), reason(outcome));
  BOOST_TEST(difference(outcome.velocity, run.velocity) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_rack_of_fifteen_is_broken_with_closed_balances) {
  for (const double gap : {0.0, 0.05}) {
    const auto network = test::rack(5, gap);
    BOOST_TEST(network.direction.size() > 30);
    const auto run = simulate(network);
    check_balances(run, 1e-8);
    BOOST_TEST(*run.energy.ratio_lab == 1, boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(a_packing_of_a_hundred_contacts_comes_to_its_end_with_closed_balances) {
  std::mt19937_64 random(33);
  const auto network = test::packing(8, 0.3, random);
  BOOST_TEST(network.direction.size() > 100);
  check_balances(simulate(network, {.accuracy = 1e-8}), 1e-6);
}

BOOST_AUTO_TEST_CASE(networks_without_sense_are_refused) {
  const auto good = test::one_on_two();
  const auto refused = [&](auto change) {
    auto network = good;
    change(network);
    BOOST_CHECK_THROW(simulate(network), InvalidParameter);
  };
  refused([](auto& n) { n.mass[0] = 0; });
  refused([](auto& n) { n.mass.pop_back(); });
  refused([](auto& n) { n.gap[0] = -1; });
  refused([](auto& n) { n.law.pop_back(); });
  refused([](auto& n) { n.direction[0][0].dof = 9; });
  refused([](auto& n) { n.direction[0].clear(); });
  refused([](auto& n) { n.velocity[0] = std::nan(""); });
  refused([](auto& n) { n.law[0] = contact::Hertz{-1}; });
  auto falling = test::equal_chain(3);
  falling.gravity = 1;
  BOOST_CHECK_THROW(model::as_network(falling), InvalidParameter);
  using Balls = std::vector<model::Ball>;
  BOOST_CHECK_THROW(model::free_balls(Balls{{{0}, {0}, 1, 1}}), InvalidParameter);
  BOOST_CHECK_THROW(model::free_balls(Balls{{{0, 0}, {0, 0}, 1, 0}}), InvalidParameter);
  BOOST_CHECK_THROW(model::ball_contact(Balls{{{0, 0}, {0, 0}, 1, 1}, {{0, 0}, {0, 0}, 1, 1}}, 0, 1),
                    InvalidParameter);
}
