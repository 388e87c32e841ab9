#define BOOST_TEST_MODULE packing of five hundred contacts
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/network/network_impact.hpp"
#include "support/networks.hpp"

using namespace mariotte;

BOOST_AUTO_TEST_CASE(a_packing_of_five_hundred_contacts_comes_to_its_end_with_closed_balances) {
  for (const double damping : {0.0, 0.3}) {
    std::mt19937_64 random(33);
    const auto network = test::packing(17, damping, random);
    BOOST_TEST(network.direction.size() >= 500);
    const auto run = impact::simulate(network, {.accuracy = 1e-8});
    BOOST_TEST((run.ending == hybrid::Ending::separated), run.message);
    BOOST_TEST(std::abs(run.energy.residual) < 1e-6 * run.energy.initial);
    BOOST_TEST(run.momentum_residual < 1e-9);
  }
}
