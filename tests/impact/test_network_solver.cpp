#define BOOST_TEST_MODULE many networks with one solver
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/network/network_balance.hpp"
#include "mariotte/impact/network/network_solver.hpp"
#include "support/allocations.hpp"
#include "support/networks.hpp"
#include "support/random_networks.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// Contacts that push on each other, and a row.
std::vector<model::Network> networks() {
  return {one_on_two(), model::as_network(equal_chain(7)), rack(3, 0)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_allocated_after_the_first_scene) {
  for (const auto& network : networks())
    BOOST_TEST(allocations_when_repeated<impact::NetworkSolver>(std::vector{network}, {.accuracy = 1e-8}) ==
               0);
}

BOOST_AUTO_TEST_CASE(it_agrees_with_the_full_result) {
  impact::NetworkSolver solver;
  for (int round = 0; round < 2; ++round)
    for (const auto& network : networks()) {
      const auto& brief = solver.solve(network, {.accuracy = 1e-10});
      const auto full = impact::simulate(network, {.accuracy = 1e-10});
      BOOST_TEST((brief.ending == full.ending));
      BOOST_TEST(difference(brief.velocity, full.velocity) < 1e-10);
      BOOST_TEST(difference(brief.impulse, impulses_of(full)) < 1e-10);
      for (std::size_t j = 0; j < full.contacts.size(); ++j)
        BOOST_TEST(brief.periods[j] == std::ssize(full.contacts[j].periods));
    }
}

BOOST_AUTO_TEST_CASE(what_was_solved_before_does_not_matter) {
  impact::NetworkSolver used, fresh;
  used.solve(rack(6, 0), {.accuracy = 1e-10});
  const auto after = used.solve(rack(3, 0), {.accuracy = 1e-10}).velocity;
  BOOST_TEST(after == fresh.solve(rack(3, 0), {.accuracy = 1e-10}).velocity,
             boost::test_tools::per_element());
}
