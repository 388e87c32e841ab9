#define BOOST_TEST_MODULE report_plot
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "mariotte/report/figure/plot.hpp"

using namespace mariotte;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

impact::Trace trace_of(std::size_t balls) {
  impact::Trace trace;
  for (const double time : {0.0, 5e-5}) {
    trace.time.push_back(time);
    trace.velocity.emplace_back(balls, 1.0);
    trace.gap.emplace_back(balls - 1, 0.0);
    trace.force.emplace_back(balls - 1, 2e4);
  }
  return trace;
}

std::string script_of(std::size_t balls, const std::string& title = "") {
  impact::ChainImpact impact;
  impact.trace = trace_of(balls);
  return report::plot_script(impact, title);
}

}  // namespace

BOOST_AUTO_TEST_CASE(axes_have_quantities_and_engineering_units) {
  const auto script = script_of(5, "Cradle");
  BOOST_TEST(has(script, "set xlabel 'time [µs]'"));
  BOOST_TEST(has(script, "set ylabel 'force [kN]'"));
  BOOST_TEST(has(script, "set ylabel 'velocity [m/s]'"));
}

BOOST_AUTO_TEST_CASE(twelve_contacts_have_a_legend_and_more_a_colour_bar) {
  BOOST_TEST(has(script_of(13), "sprintf('contact %d', i)"));
  BOOST_TEST(!has(script_of(14), "sprintf('contact %d', i)"));
  BOOST_TEST(has(script_of(14), "set cblabel 'contact'"));
}

BOOST_AUTO_TEST_CASE(a_faint_late_contact_does_not_stretch_the_axis) {
  impact::ChainImpact impact;
  auto& trace = impact.trace = trace_of(3);
  trace.time.push_back(1.0);
  trace.velocity.push_back({1, 1, 1});
  trace.gap.push_back({0, 0});
  trace.force.push_back({1e-3, 0});
  BOOST_TEST(has(report::plot_script(impact, ""), "set xrange [0:55]\n"));
}

BOOST_AUTO_TEST_CASE(a_long_flight_before_the_contacts_is_left_out) {
  impact::ChainImpact impact;
  auto& trace = impact.trace = trace_of(2);
  trace.time = {0, 1.5, 1.75, 2, 3};
  trace.velocity.assign(5, {1, 1});
  trace.gap.assign(5, {0});
  trace.force = {{0}, {0}, {1}, {1}, {0}};
  BOOST_TEST(has(report::plot_script(impact, ""), "set xrange [1.45:2.05]\n"));
}

BOOST_AUTO_TEST_CASE(two_samples_make_an_axis) {
  impact::ChainImpact impact;
  impact.trace = trace_of(2);
  impact.trace.force = {{0}, {1}};
  BOOST_TEST(has(report::plot_script(impact, ""), "set xrange [0:50]\n"));
}

BOOST_AUTO_TEST_CASE(walls_and_coordinates_have_their_names) {
  impact::ChainImpact impact;
  impact.trace = trace_of(2);
  const auto script = report::plot_script(impact, "", {.velocities = {"wall 1", "ball 2"}, .contacts = {}});
  BOOST_TEST(has(script, "array name[2] = ['wall 1', 'ball 2']"));
  BOOST_TEST(has(script, "title name[i]"));
  scene::Scene scene;
  scene.model =
      model::Chain{.mass = {infinity, 2}, .law = {contact::Hertz{1}}, .gap = {0}, .velocity = {0, 0}};
  BOOST_TEST(report::curve_names(scene).velocities == (std::vector<std::string>{"wall 1", "ball 2"}),
             boost::test_tools::per_element());
  model::Network plane;
  plane.dimension = 2;
  plane.velocity = {0, 0, 0, 0};
  scene.model = plane;
  BOOST_TEST(report::curve_names(scene).velocities ==
                 (std::vector<std::string>{"ball 1 x", "ball 1 y", "ball 2 x", "ball 2 y"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_title_cannot_leave_its_quotes) {
  const auto script = script_of(2, "it's\n`date`");
  BOOST_TEST(has(script, "set title 'it''s `date`: contact forces' noenhanced"));
}

BOOST_AUTO_TEST_CASE(data_have_a_block_per_ball_and_per_contact) {
  BOOST_TEST(report::plot_data(trace_of(2)) ==
             "# ball, time [s], velocity [m/s]\n1,0,1\n1,5e-05,1\n\n\n2,0,1\n2,5e-05,1\n\n\n"
             "# contact, time [s], force [N]\n1,0,20000\n1,5e-05,20000\n\n\n");
}

BOOST_AUTO_TEST_CASE(data_of_a_long_chain_are_those_of_evenly_spaced_balls) {
  const auto data = report::plot_data(trace_of(500));
  BOOST_TEST(has(data, "\n\n6,0,1\n"));
  BOOST_TEST(has(data, "\n\n496,0,1\n"));
  BOOST_TEST(std::count(data.begin(), data.end(), '\n') == 2 + 2 * 100 * 4);
}

BOOST_AUTO_TEST_CASE(data_leave_out_points_on_a_level_stretch) {
  auto trace = trace_of(2);
  trace.time = {0, 1, 2, 3, 4, 5};
  trace.velocity.assign(6, {0, 0});
  trace.force = {{0}, {0}, {0}, {1}, {1.00001}, {1}};
  const auto data = report::plot_data(trace);
  BOOST_TEST(has(data, "1,0,0\n1,2,0\n1,3,1\n1,5,1\n"));
}

BOOST_AUTO_TEST_CASE(phases_are_shaded_between_events_the_darker_the_more_contacts_are_closed) {
  impact::ChainImpact impact;
  impact.trace = trace_of(3);
  impact.events = {{0, {}, {0, 1}}, {2e-5, {0}, {}}, {4e-5, {1}, {}}};
  const auto script = report::plot_script(impact, "");
  BOOST_TEST(has(script, "rectangle from 0, graph 0 to 20, graph 1 behind fillcolor rgb '#e6ecf3'"));
  BOOST_TEST(has(script, "rectangle from 20, graph 0 to 40, graph 1 behind fillcolor rgb '#f1f4f8'"));
  BOOST_TEST(!has(script, "rectangle from 40"));
  BOOST_TEST(has(script, "set label '1–2 close' at 0, "));
  BOOST_TEST(has(script, "set label '2 open' at 40, "));
}

BOOST_AUTO_TEST_CASE(too_many_events_to_tell_apart_are_not_marked) {
  impact::ChainImpact impact;
  impact.trace = trace_of(3);
  for (int i = 0; i < 13; ++i) impact.events.push_back({1e-6 * i, {}, {0}});
  BOOST_TEST(!has(report::plot_script(impact, ""), "set label"));
}
