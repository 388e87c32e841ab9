#define BOOST_TEST_MODULE instant
#include <boost/test/unit_test.hpp>
#include <limits>

#include "mariotte/core/instant.hpp"

using namespace mariotte;

BOOST_AUTO_TEST_CASE(a_microsecond_a_year_after_the_start_keeps_its_digits) {
  const Instant late = Instant{3e7} + 0.1;
  const Instant later = late + 1e-6;
  BOOST_TEST((later > late));
  BOOST_TEST(std::abs((later - late) - 1e-6) < 1e-21);
}

BOOST_AUTO_TEST_CASE(a_million_small_durations_add_up) {
  Instant t{1e6};
  for (int i = 0; i < 1000000; ++i) t = t + 0.1;
  // 0.1 as a double is 0.1 + 5.55e-18
  BOOST_TEST(std::abs((t - Instant{1.1e6}) - 5.551115123125783e-12) < 1e-20);
}

BOOST_AUTO_TEST_CASE(never_is_later_than_everything) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Instant never = Instant{1} + infinity;
  BOOST_TEST(never.value == infinity);
  BOOST_TEST((never > Instant{1e300}));
}
