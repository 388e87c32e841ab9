#define BOOST_TEST_MODULE report_csv
#include <boost/test/unit_test.hpp>

#include "mariotte/report/csv/csv.hpp"
#include "report/three_balls.hpp"

using namespace mariotte;

BOOST_AUTO_TEST_CASE(events_list_contacts_from_one_with_exact_times) {
  auto impact = support::three_balls_impact();
  impact.events = {{.time = 0.1, .open = {}, .close = {0, 1}}, {.time = 2, .open = {1}, .close = {}}};
  BOOST_TEST(report::events_csv(impact) == "time [s],open,close\n0.10000000000000001,,1 2\n2,2,\n");
}

BOOST_AUTO_TEST_CASE(trace_has_a_named_column_with_unit_for_every_ball_and_contact) {
  auto impact = support::three_balls_impact();
  impact.trace = {.time = {0.1}, .velocity = {{1, 2, 3}}, .gap = {{4, 5}}, .force = {{1.0 / 3, 7}}};
  BOOST_TEST(report::trace_csv(impact) ==
             "time [s],v1 [m/s],v2 [m/s],v3 [m/s],gap1 [m],gap2 [m],force1 [N],force2 [N]\n"
             "0.10000000000000001,1,2,3,4,5,0.33333333333333331,7\n");
}

BOOST_AUTO_TEST_CASE(velocities_of_balls_in_the_plane_name_ball_and_axis) {
  BOOST_TEST(report::trace_header({0, 1, 2, 3}, {}, "m/s", 2) ==
             "time [s],v1x [m/s],v1y [m/s],v2x [m/s],v2y [m/s]\n");
  BOOST_TEST(report::trace_header({5}, {0}, "m/s", 3) == "time [s],v2z [m/s],gap1 [m],force1 [N]\n");
}

BOOST_AUTO_TEST_CASE(an_empty_trace_is_a_header_alone) {
  const auto text = report::trace_csv(support::three_balls_impact());
  BOOST_TEST(text.find('\n') == text.size() - 1);
}
