#define BOOST_TEST_MODULE report_run_progress
#include <boost/test/unit_test.hpp>
#include <limits>

#include "mariotte/report/run_progress.hpp"

using mariotte::report::progress_text;

BOOST_AUTO_TEST_CASE(a_run_without_a_limit_claims_no_end) {
  const double none = std::numeric_limits<double>::infinity();
  BOOST_TEST(progress_text({1.25e-3, 4000}, none, 3) == "at 1.25 ms after 3 s, 4000 events");
  BOOST_TEST(progress_text({2, 1}, none, 12.4) == "at 2 s after 12 s, 1 event");
}

BOOST_AUTO_TEST_CASE(an_end_is_forecast_from_a_tenth_of_the_limit_on) {
  BOOST_TEST(progress_text({0.99, 500}, 10, 3) == "at 0.99 s after 3 s, 500 events");
  BOOST_TEST(progress_text({2, 500}, 10, 3) ==
             "at 2 s after 3 s, 500 events; about 12 s more to the time limit");
}
