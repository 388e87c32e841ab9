// A hundred thousand grazes, down to ten times the accuracy; see test_grazes.cpp for a taste of them.
#define BOOST_TEST_MODULE all grazes
#include <boost/test/unit_test.hpp>
#include <iostream>

#include "support/graze_campaign.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

void check_all(const std::vector<std::string>& flows) {
  const auto campaign = run_campaign(100'000, flows);
  std::cout << campaign;
  BOOST_TEST(campaign.losing > 49'000u);
  BOOST_TEST(campaign.keeping > 49'000u);
  for (const auto& scene : campaign.wrong) BOOST_ERROR(scene);
}

}  // namespace

BOOST_AUTO_TEST_CASE(of_1e5_grazes_none_is_missed_and_none_invented) {
  check_all({"auto", "taylor"});
}

BOOST_AUTO_TEST_CASE(adams_with_the_certificate_misses_none_of_them) {
  check_all({"cvode-adams"});
}
