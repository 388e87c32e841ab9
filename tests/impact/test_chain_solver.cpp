#define BOOST_TEST_MODULE many chains with one solver
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/impulses.hpp"
#include "support/allocations.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

long allocations_when_repeated(const std::vector<model::Chain>& chains) {
  return test::allocations_when_repeated<impact::ChainSolver>(chains, {.accuracy = 1e-8});
}

/// Random rows of Hertz balls, of which the first strikes.
model::Chain random_row(std::mt19937& random) {
  std::uniform_real_distribution<> share(0, 1);
  const auto n = static_cast<std::size_t>(4 + 12 * share(random));
  const bool touching = share(random) < 0.5;
  model::Chain row{.mass = {}, .law = {}, .gap = {}, .velocity = std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) row.mass.push_back(std::pow(4, share(random)));
  for (std::size_t j = 0; j + 1 < n; ++j) {
    row.law.push_back(contact::Hertz(std::pow(4, share(random))));
    row.gap.push_back(touching ? 0 : share(random) * share(random));
  }
  row.velocity[0] = 1;
  return row;
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_allocated_after_the_first_scene) {
  std::vector<model::Chain> chains;
  for (const auto& c : cases("triplets.json"))
    if (c.at("law") == "hertz") chains.push_back(triplet(c));
  BOOST_TEST(allocations_when_repeated(chains) == 0);
  BOOST_TEST(allocations_when_repeated({equal_chain(21)}) == 0);
}

BOOST_AUTO_TEST_CASE(it_agrees_with_the_full_result) {
  impact::ChainSolver solver;
  for (const auto& c : cases("triplets.json")) {
    const auto chain = triplet(c);
    const auto& brief = solver.solve(chain, {.accuracy = 1e-10});
    const auto full = impact::simulate(chain, {.accuracy = 1e-10});
    BOOST_TEST(difference(brief.velocity, full.velocity) < 1e-10);
    BOOST_TEST(difference(brief.impulse, impulses(full)) < 1e-10);
    const auto counts = period_counts(full);
    BOOST_TEST(std::equal(counts.begin(), counts.end(), brief.periods.begin(),
                          [](std::size_t a, Index b) { return static_cast<Index>(a) == b; }));
    BOOST_TEST((brief.ending == full.ending));
  }
}

BOOST_AUTO_TEST_CASE(chains_of_any_kind_may_follow_each_other) {
  const std::vector<model::Chain> chains = {
      equal_chain(5), equal_masses({contact::Linear{1}, contact::Linear{5}}, {1, 0, 0}),
      equal_masses({contact::Viscoelastic{.stiffness = 1, .damping = 20, .exponent = 1.5}}, {1, 0}),
      equal_chain(3),
      equal_masses({contact::Viscoelastic{.stiffness = 1, .damping = 30, .exponent = 1.5}, contact::Hertz{1}},
                   {1, 0, 0})};
  impact::ChainSolver solver;
  for (int round = 0; round < 2; ++round)
    for (const auto& chain : chains)
      BOOST_TEST(difference(solver.solve(chain).velocity, impact::simulate(chain).velocity) < 1e-10);
}

BOOST_AUTO_TEST_CASE(a_map_ends_separated_everywhere_at_any_accuracy) {
  impact::ChainSolver solver;
  for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-5, 1e-7, 1e-9, 1e-13})
    for (int i = 0; i < 64 * 64; ++i) {
      const double ratio = 0.1 * std::pow(100.0, (i / 64) / 63.0), third = -1 + (i % 64) / 63.0;
      const auto& impact = solver.solve(
          equal_masses({contact::Hertz{1}, contact::Hertz{ratio}}, {1, 0, third}), {.accuracy = accuracy});
      BOOST_TEST_CONTEXT(accuracy << ", " << ratio << ", " << third << ": " << impact.message)
      BOOST_TEST((impact.ending == hybrid::Ending::separated));
    }
}

// Balls that have lost all but rounding to their neighbours hover in each other's contacts without force.
BOOST_AUTO_TEST_CASE(contacts_without_force_do_not_bound_a_step) {
  const model::Chain chain{.mass = std::vector<double>(9, 1.0),
                           .law = std::vector<contact::Law>(
                               8, contact::Viscoelastic{.stiffness = 1, .exponent = 2.3860876585527651}),
                           .gap = std::vector<double>(8),
                           .velocity = {-1, -1, -1, -1, 0, -0.5, -1, 1, 0}};
  impact::ChainSolver solver;
  for (const double accuracy : {1e-12, 1e-13}) {
    const auto& impact = solver.solve(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated));
    BOOST_TEST(impact.steps < 1000);
  }
}

BOOST_AUTO_TEST_CASE(rows_that_go_on_past_events_come_to_the_same) {
  std::mt19937 random(17);
  impact::ChainSolver quick, stopping(impact::Course::of_simulate);
  for (int i = 0; i < 300; ++i) {
    const auto row = random_row(random);
    for (const double accuracy : {1e-6, 1e-11}) {
      const auto expected = stopping.solve(row, {.accuracy = accuracy});
      const auto& impact = quick.solve(row, {.accuracy = accuracy});
      BOOST_TEST(difference(impact.velocity, expected.velocity) < accuracy);
      BOOST_TEST(difference(impact.impulse, expected.impulse) <
                 accuracy * model::kinetic_energy(row, row.velocity));
      const bool flies_for_long = expected.time > 100;  // the last to meet do so with hardly any speed
      BOOST_TEST((flies_for_long || std::abs(impact.time - expected.time) < 1000 * accuracy));
      BOOST_TEST(impact.periods == expected.periods, boost::test_tools::per_element());
      BOOST_TEST(impact.events == expected.events);
      BOOST_TEST((impact.ending == expected.ending));
    }
  }
}

BOOST_AUTO_TEST_CASE(most_events_of_a_wave_are_passed) {
  model::ChainSystem system;
  system.reset(equal_chain(21), 1e-8, false);
  std::vector<double> start;
  model::initial_state(system.chain(), system.layout(), start);
  hybrid::Workspace<model::ChainSystem> workspace;
  Index phases[2], events[2];
  for (const bool passes : {false, true}) {
    workspace.passes_events = passes;
    const auto& run = hybrid::simulate(system, start, {.accuracy = 1e-8}, workspace);
    events[passes] = run.events;
    phases[passes] = run.flows[static_cast<std::size_t>(flow::Kind::taylor)].phases;
    for (std::size_t i = 1; i < run.changes.size(); ++i)
      BOOST_TEST(run.changes[i - 1].time <= run.changes[i].time);
  }
  BOOST_TEST(events[1] == events[0]);
  BOOST_TEST(phases[0] > 15);
  BOOST_TEST(phases[1] < 3);
}

BOOST_AUTO_TEST_CASE(limits_of_events_hold_where_events_are_passed) {
  impact::ChainSolver quick, stopping(impact::Course::of_simulate);
  for (Index most = 1; most <= 22; ++most) {
    const hybrid::Options options{.accuracy = 1e-13, .max_events = most};
    const auto expected = stopping.solve(equal_chain(21), options);
    const auto& impact = quick.solve(equal_chain(21), options);
    BOOST_TEST(impact.events == expected.events);
    BOOST_TEST((impact.ending == expected.ending));
    BOOST_TEST(difference(impact.velocity, expected.velocity) < 1e-9);
  }
}
