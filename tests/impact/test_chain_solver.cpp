#define BOOST_TEST_MODULE many chains with one solver
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "support/allocations.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

long allocations_when_repeated(const std::vector<model::Chain>& chains) {
  return test::allocations_when_repeated<impact::ChainSolver>(chains, {.accuracy = 1e-8});
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
