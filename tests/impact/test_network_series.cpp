#define BOOST_TEST_MODULE network series
// Series of contacts linked in any way, against CVODE.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <optional>

#include "mariotte/impact/network/network_impact.hpp"
#include "support/networks.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::impact;
using test::difference;

BOOST_AUTO_TEST_CASE(series_of_racks_agree_with_cvode) {
  for (const double touching : {0.0, 1e-3})
    for (const int rows : {3, 5}) {
      const auto network = test::rack(rows, touching);
      const auto by = [&](std::optional<flow::Kind> kind, double accuracy) {
        return simulate(network, {.accuracy = accuracy, .flow = kind});
      };
      const auto exact = by(flow::Kind::cvode_adams, 1e-13);
      for (const double accuracy : {1e-6, 1e-9, 1e-11}) {
        const auto run = by(std::nullopt, accuracy);
        BOOST_TEST((run.ending == hybrid::Ending::separated));
        BOOST_TEST(run.flows.back().name == "taylor");
        BOOST_TEST(difference(run.velocity, exact.velocity) < accuracy);
      }
    }
}

// Most disks rest until the wave comes, or fly freely behind it.
BOOST_AUTO_TEST_CASE(series_of_a_wave_in_a_packing_agree_with_cvode) {
  std::vector<model::Ball> disks;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) disks.push_back({{j + 0.5 * (i % 2), i * std::sqrt(0.75)}, {0, 0}, 1, 0.5});
  disks.front().velocity = {1, 0.3};
  for (const double apart : {0.0, 0.02}) {
    auto network = model::ball_network(disks, 0.1, test::hertz_of_pair);
    for (std::size_t j = 0; j < network.gap.size(); ++j) network.gap[j] = apart * static_cast<double>(j % 4);
    const auto by = [&](std::optional<flow::Kind> kind, double accuracy) {
      return simulate(network, {.accuracy = accuracy, .flow = kind});
    };
    const auto exact = by(flow::Kind::cvode_adams, 1e-13);
    for (const double accuracy : {1e-6, 1e-9}) {
      const auto run = by(flow::Kind::taylor, accuracy);
      BOOST_TEST((run.ending == hybrid::Ending::separated));
      BOOST_TEST(difference(run.velocity, exact.velocity) < accuracy);
      BOOST_TEST(difference(run.gap, exact.gap) < 1e4 * accuracy);
      for (std::size_t j = 0; j < run.contacts.size(); ++j)
        BOOST_TEST(std::abs(run.contacts[j].impulse - exact.contacts[j].impulse) < accuracy);
    }
  }
}
