#define BOOST_TEST_MODULE report_panels
#include <boost/test/unit_test.hpp>

#include "mariotte/report/figure/time_figure.hpp"
#include "report/plot_scripts.hpp"

using namespace mariotte;
using namespace mariotte::test;

BOOST_AUTO_TEST_CASE(impacts_far_apart_have_panels_of_their_own) {
  auto trace = trace_of(2);
  trace.time = {0, 2, 3, 90, 92, 93};
  trace.velocity.assign(6, {1, 1});
  trace.gap.assign(6, {0});
  trace.force = {{0}, {1}, {0}, {0}, {1}, {0}};
  const auto script = script_of(trace);
  BOOST_TEST(count(script, "set xrange [0:2.2]\n") == 2 * terminals);
  BOOST_TEST(count(script, "set xrange [89.8:92.2]\n") == 2 * terminals);
}

BOOST_AUTO_TEST_CASE(forces_of_many_impacts_far_apart_are_those_of_the_strongest) {
  auto trace = trace_of(2);
  trace.time = {0};
  trace.velocity = {{1, 0}};
  trace.gap = {{0}};
  trace.force = {{0}};
  for (const double peak : {1.0, 7.0, 2.0, 9.0, 8.0}) {
    const double start = trace.time.back() + 1e-3;
    for (const auto& [after, force] : {std::pair{0.0, 0.0}, {1e-5, peak}, {2e-5, 0.0}}) {
      trace.time.push_back(start + after);
      trace.velocity.push_back({1, 0});
      trace.gap.push_back({0});
      trace.force.push_back({force});
    }
  }
  const auto script = script_of(trace);
  BOOST_TEST(count(script, "set label 'time t [ms]: 3 strongest of 5 impacts'") == terminals);
  BOOST_TEST(count(script, "set label 'time t [ms]'") == terminals);         // velocities, from first to last
  BOOST_TEST(count(script, "set label 'f_{1}' at graph") == 2 * terminals);  // the first, and the peak
  const auto action = report::action_of(trace);
  BOOST_TEST_REQUIRE(action.strongest.size() == 3u);
  BOOST_TEST(action.strongest[0].start < 2.03e-3);
  BOOST_TEST(action.strongest[0].end > 2.03e-3);
  BOOST_TEST(action.strongest[1].start > 4e-3);
}

BOOST_AUTO_TEST_CASE(forces_of_brief_impacts_are_drawn_apart_from_what_pushes_all_the_while) {
  auto trace = trace_of(2);
  trace.time = {0, 1, 1.00001, 1.00002, 2, 3};
  trace.velocity.assign(6, {1, 0});
  trace.gap.assign(6, {0});
  trace.force = {{2}, {2}, {500}, {2}, {2}, {2}};
  const auto action = report::action_of(trace);
  BOOST_TEST(action.windows.front().end == 3);
  BOOST_TEST_REQUIRE(action.strongest.size() == 1u);
  BOOST_TEST(action.strongest[0].start > 0.99);
  BOOST_TEST(action.strongest[0].end < 1.01);
  const auto script = script_of(trace);
  BOOST_TEST(count(script, "set label 'time t [s]: where forces are strong'") == terminals);
  BOOST_TEST(count(script, "set label 'time t [s]'") == terminals);
}

BOOST_AUTO_TEST_CASE(a_window_of_ones_own_is_shown) {
  impact::ChainImpact impact;
  impact.trace = trace_of(3);
  const auto script = report::plot(impact, "", {}, {.window = {{1e-5, 2e-5}}}).script;
  BOOST_TEST(count(script, "set xrange [10:20]\n") == 2 * terminals);
}

BOOST_AUTO_TEST_CASE(a_panel_has_two_numbers_at_least) {
  const report::TimeAxis axis{{1e3, "ms", 0}, {{18.346e-3, 18.414e-3}, {33.826e-3, 33.894e-3}}, {}};
  const auto script = report::on_panels("f", "", axis, report::panels(axis.windows, 130),
                                        [](const report::Panel&) { return "plot 0\n"; });
  BOOST_TEST(has(script, "set xtics 18.36,0.04,18.4\n"), script);
  BOOST_TEST(has(script, "set xtics 33.84,0.04,33.88\n"));
}

BOOST_AUTO_TEST_CASE(panels_too_short_for_their_times_count_from_their_first_event) {
  const report::TimeAxis axis{{1, "s", 0},
                              {{0.10083, 0.10089}, {0.20035, 0.20041}, {0.30035, 0.30041}},
                              {{.time = 0.10084, .close = {0}}, {.time = 0.10088, .open = {0}}}};
  const auto script = report::on_panels("f", "", axis, report::panels(axis.windows, 130),
                                        [](const report::Panel&) { return "plot 0\n"; });
  BOOST_TEST(has(script, "set xtics ('0' 0.10084, '40' 0.10088)\n"), script);
  BOOST_TEST(has(script, "set label '{/*0.8 0.10084 s}' at graph 0.5,"));
  BOOST_TEST(has(script, "set label '{/*0.8 0.20035 s}' at graph 0.5,"));
  BOOST_TEST(has(script, "set label 'time t − t_0 [µs]' at screen"));
}

BOOST_AUTO_TEST_CASE(the_time_axis_has_one_name_below_the_middle_of_its_panels) {
  const report::TimeAxis axis{{1e3, "ms", 0}, {{0, 1e-3}, {5e-3, 6e-3}}, {}};
  const auto script = report::on_panels("f", "", axis, report::panels(axis.windows, 100),
                                        [](const report::Panel&) { return "plot 0\n"; });
  BOOST_TEST(count(script, "set label 'time t [ms]' at screen 0.4778,") == terminals);
}

BOOST_AUTO_TEST_CASE(a_faint_late_contact_does_not_stretch_the_axis) {
  auto trace = trace_of(3);
  trace.time.push_back(1.0);
  trace.velocity.push_back({1, 1, 1});
  trace.gap.push_back({0, 0});
  trace.force.push_back({1e-3, 0});
  BOOST_TEST(has(script_of(trace), "set xrange [0:55]\n"));
}

BOOST_AUTO_TEST_CASE(a_long_flight_before_the_contacts_is_left_out) {
  auto trace = trace_of(2);
  trace.time = {0, 1.5, 1.75, 2, 3};
  trace.velocity.assign(5, {1, 1});
  trace.gap.assign(5, {0});
  trace.force = {{0}, {0}, {1}, {1}, {0}};
  BOOST_TEST(has(script_of(trace), "set xrange [1.45:2.05]\n"));
}

BOOST_AUTO_TEST_CASE(names_wider_than_a_panel_stand_at_the_end_and_their_symbols_above_the_peaks) {
  auto trace = trace_of(3);
  trace.time = {0, 2, 3, 90, 92, 93, 180, 182, 183};
  trace.velocity.assign(9, {1, 1, 1});
  trace.gap.assign(9, {0, 0});
  trace.force = {{0, 0}, {1, 0}, {0, 0}, {0, 0}, {0, 1}, {0, 0}, {0, 0}, {1, 0}, {0, 0}};
  const report::CurveNames names{.velocities = {},
                                 .contacts = {"f_{1} (belt of rubber–dumbbell.1)", "f_{2} (wall–a)"}};
  const auto script = report::plot(impact_of(trace), "", names).script;
  BOOST_TEST(has(script, "set label 'f_{1}' at"), script);
  BOOST_TEST(has(script, "set label 'f_{1} (belt of rubber–dumbbell.1)' at"));
  BOOST_TEST(has(script, "set label 'f_{2}' at"));
  BOOST_TEST(has(script, "set label 'f_{2} (wall–a)' at"));
}
