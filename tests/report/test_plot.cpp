#define BOOST_TEST_MODULE report_plot
#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "mariotte/report/figure/event_marks.hpp"
#include "mariotte/report/figure/plot.hpp"
#include "mariotte/report/figure/time_figure.hpp"
#include "report/plot_scripts.hpp"

using namespace mariotte;
using namespace mariotte::test;

BOOST_AUTO_TEST_CASE(axes_have_quantities_symbols_and_engineering_units) {
  const auto script = plot_of(5, "Cradle").script;
  BOOST_TEST(has(script, "set label 'time t [µs]' at screen"));
  BOOST_TEST(has(script, "set label 'contact force f [kN]' at screen"));
  BOOST_TEST(has(script, "set label 'velocity v [m/s]' at screen"));
}

// gnuplot's own format begins with a blank, which shifts a number beside its tick.
BOOST_AUTO_TEST_CASE(numbers_stand_below_their_ticks_and_have_a_minus_that_is_no_hyphen) {
  for (const std::size_t balls : {2, 14}) {
    const auto script = plot_of(balls).script;
    BOOST_TEST(has(script, "set minussign\nset format '%h'\n"));
    BOOST_TEST(!has(script, "set format cb\n"));
  }
}

BOOST_AUTO_TEST_CASE(twelve_contacts_are_curves_and_more_an_image) {
  BOOST_TEST(has(plot_of(13).script, "index 1 using (1e+06*$2):(0.001*$3) with lines lt 1"));
  const auto script = plot_of(14).script;
  BOOST_TEST(!has(script, "with lines"));
  BOOST_TEST(count(script, "with image") == 2 * terminals);
  BOOST_TEST(has(script, "set label 'contact j' at screen"));
  BOOST_TEST(has(script, "set cblabel 'contact force f [kN]'"));
}

BOOST_AUTO_TEST_CASE(an_image_has_the_greatest_magnitude_within_each_cell) {
  auto trace = trace_of(14);
  trace.time = {0, 0.4999, 0.5, 0.5001, 1};
  trace.velocity.assign(5, std::vector<double>(14, 0));
  trace.force.assign(5, std::vector<double>(13, 1));
  trace.velocity[2][3] = -7;  // thinner than a cell
  const auto data = report::plot(impact_of(trace), "").data;
  BOOST_TEST(has(data, ",-7,"));
}

BOOST_AUTO_TEST_CASE(more_than_six_balls_in_the_plane_are_shown_by_their_speeds) {
  for (const std::size_t balls : {7, 20}) {
    auto trace = trace_of(2 * balls);
    for (auto& row : trace.velocity) row[0] = 3, row[1] = 4;
    const auto plot = report::plot(impact_of(trace), "", {.velocities = {}, .contacts = {}, .dimension = 2});
    BOOST_TEST(
        has(plot.script, balls == 7 ? "set label 'speed v [m/s]' at screen" : "set cblabel 'speed v [m/s]'"));
    BOOST_TEST(has(plot.script, balls == 7 ? "'ball 1' at" : "set yrange [0.5:20.5]"));
    BOOST_TEST(has(plot.data, balls == 7 ? "\n1,0,5\n" : "\n5,1.4142,"));
  }
}

BOOST_AUTO_TEST_CASE(chosen_balls_and_contacts_of_a_long_row_are_curves) {
  auto trace = trace_of(20);
  trace.velocity[0][19] = 7;
  const auto plot = report::plot(impact_of(trace), "", {}, {.balls = {20, 1, 99}, .contacts = {3}});
  BOOST_TEST(has(plot.script, "'ball 20' at"));
  BOOST_TEST(has(plot.script, "'f_{3}' at"));
  BOOST_TEST(!has(plot.script, "with image"));
  BOOST_TEST(has(plot.data, "\n1,0,7\n"));
  BOOST_TEST(has(report::plot(impact_of(trace), "", {}, {.balls = {99}}).script, "with image"));
}

BOOST_AUTO_TEST_CASE(chosen_balls_in_the_plane_keep_their_components_or_are_speeds) {
  const auto script = [](const std::vector<Index>& balls) {
    auto trace = trace_of(40);
    trace.velocity[0][38] = 7;
    return report::plot(impact_of(trace), "", {.velocities = {}, .contacts = {}, .dimension = 2},
                        {.balls = balls})
        .script;
  };
  BOOST_TEST(has(script({20}), "'ball 39' at"));
  BOOST_TEST(has(script({1, 2, 3, 4, 5, 6, 20}), "'ball 20' at"));
}

BOOST_AUTO_TEST_CASE(colours_of_images_are_logarithmic_on_demand) {
  impact::ChainImpact impact;
  impact.trace = trace_of(14);
  impact.trace.force[0][0] = 10;
  const auto even = report::plot(impact, "").script;
  const auto logarithmic = report::plot(impact, "", {}, {.window = {}, .logarithmic = true}).script;
  BOOST_TEST(!has(even, "set logscale cb"));
  BOOST_TEST(has(logarithmic, "set logscale cb"));
  BOOST_TEST(has(logarithmic, "set cblabel '|contact force f| [kN]'"));
  BOOST_TEST(has(logarithmic, "set format cb '10^{%T}'"));
  impact.trace.force[0][0] = 1e4;
  impact.trace.velocity[0][0] = 0.5;
  BOOST_TEST(
      !has(report::plot(impact, "", {}, {.window = {}, .logarithmic = true}).script, "set logscale cb"));
}

BOOST_AUTO_TEST_CASE(colours_of_images_span_the_values_that_are_shown) {
  auto impact = impact_of(trace_of(14));
  const auto range = [&](double least, const scene::Figure& figure = {}) {
    impact.trace.force[0][0] = least;
    const auto script = report::plot(impact, "", {}, figure).script;
    const auto at = script.find("cbrange", script.find("cblabel 'velocity"));
    return script.substr(at, script.find('\n', at) - at);
  };
  BOOST_TEST(range(1.9e4) == "cbrange [19:20]");
  BOOST_TEST(range(5e3) == "cbrange [0:20]");
  BOOST_TEST(range(-5e3) == "cbrange [-5:20]");
  BOOST_TEST(range(1e4, {.window = {{2.5e-5, 5e-5}}}) == "cbrange [15:20]");
}

BOOST_AUTO_TEST_CASE(long_numbers_below_the_axis_are_fewer) {
  const auto impact = impact_of(trace_of(2));
  BOOST_TEST(has(report::plot(impact, "", {}, {.window = {{1e-6, 5e-6}}}).script, "set xtics 1\n"));
  BOOST_TEST(has(report::plot(impact, "", {}, {.window = {{0.1429, 0.143}}}).script, "set xtics 5e-05\n"));
}

BOOST_AUTO_TEST_CASE(two_samples_make_an_axis) {
  auto trace = trace_of(2);
  trace.force = {{0}, {1}};
  BOOST_TEST(has(script_of(trace), "set xrange [0:50]\n"));
}

BOOST_AUTO_TEST_CASE(curves_are_named_beside_them) {
  auto trace = trace_of(2);
  trace.velocity = {{1, 0}, {0.5, 0.5}};
  trace.velocity[1] = {0, 1};
  const auto script =
      report::plot(impact_of(trace), "", {.velocities = {"wall", "ball 2"}, .contacts = {"f_{1} (1–2)"}})
          .script;
  BOOST_TEST(has(script, "set label 'wall' at graph"));
  BOOST_TEST(has(script, "set label 'ball 2' at graph"));
  BOOST_TEST(has(script, "set label 'f_{1} (1–2)' at graph"));
  BOOST_TEST(has(script, "notitle"));
}

BOOST_AUTO_TEST_CASE(curves_that_coincide_are_drawn_once_with_all_names) {
  auto trace = trace_of(4);
  trace.velocity = {{0, 0, 0, 1}, {1, 1.0001, 0, 0.5}};
  const auto script = script_of(trace);
  BOOST_TEST(count(script, "set label 'ball 1' at graph") == terminals);
  BOOST_TEST(count(script, "set label 'ball 2' at graph") == terminals);
  BOOST_TEST(has(script, "set label 'f_{1}, f_{2}, f_{3}' at graph"));
  BOOST_TEST(count(script, "'plot.csv' index") == terminals * (3 + 1));
}

BOOST_AUTO_TEST_CASE(leaders_to_names_are_thin_and_grey_unlike_data) {
  constexpr const char* grey = "nohead lc rgb '#9aa5b1' lw 0.7 dt solid";
  auto trace = trace_of(3);
  trace.time = {0, 1e-5, 2e-5};
  trace.velocity.assign(3, {0, 0.5, 1});
  trace.gap.assign(3, {0, 0});
  trace.force = {{0, 0}, {1, 1.02}, {0, 0}};  // the names of both peaks do not fit side by side
  BOOST_TEST(count(script_of(trace), grey) == terminals * (3 + 1));
  trace.force = {{0, 0}, {1, 2}, {0, 0}};
  BOOST_TEST(count(script_of(trace), grey) == terminals * 3);
  BOOST_TEST(!has(script_of(trace), "nohead lt"));
}

BOOST_AUTO_TEST_CASE(among_many_pulses_names_stand_at_the_end) {
  auto trace = trace_of(3);
  trace.time.clear();
  for (auto* rows : {&trace.velocity, &trace.gap, &trace.force}) rows->clear();
  for (int k = 0; k < 11; ++k) {
    trace.time.push_back(k * 1e-5);
    trace.velocity.push_back({0, 0.5, 1});
    trace.gap.push_back({0, 0});
    trace.force.push_back({k % 2 ? 1.0 : 0.0, 0.5});
  }
  BOOST_TEST(count(script_of(trace), "center front textcolor lt") == 0);
  for (std::size_t k = 8; k < 11; ++k) trace.force[k][0] = 0;  // four pulses
  BOOST_TEST(count(script_of(trace), "center front textcolor lt") == terminals * 2);
}

BOOST_AUTO_TEST_CASE(walls_and_coordinates_have_their_names) {
  scene::Scene scene;
  scene.model =
      model::Chain{.mass = {infinity, 2}, .law = {contact::Hertz{1}}, .gap = {0}, .velocity = {0, 0}};
  BOOST_TEST(report::curve_names(scene).velocities == (std::vector<std::string>{"wall", "ball 2"}),
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
  const auto script = plot_of(2, "it's\n`date`").script;
  BOOST_TEST(has(script, "set label 'it''s `date`' at screen"));
}

BOOST_AUTO_TEST_CASE(a_name_cannot_leave_its_quotes) {
  impact::ChainImpact impact;
  impact.trace = trace_of(2);
  impact.trace.velocity[1] = {0.5, 2};
  report::CurveNames names;
  names.velocities = {"a'; system(\"date\"); set label 'b", "O'Brien"};
  const auto script = report::plot(impact, "", names).script;
  BOOST_TEST(has(script, "set label 'a''; system(\"date\"); set label ''b' at"));
  BOOST_TEST(has(script, "set label 'O''Brien' at"));
}

BOOST_AUTO_TEST_CASE(data_have_a_block_per_ball_and_per_contact) {
  BOOST_TEST(plot_of(2).data ==
             "# velocity v [m/s]\n1,0,1\n1,5e-05,1\n\n\n2,0,1\n2,5e-05,1\n\n\n"
             "# contact force f [N]\n1,0,20000\n1,5e-05,20000\n\n\n");
}

BOOST_AUTO_TEST_CASE(data_leave_out_points_on_a_level_stretch) {
  auto trace = trace_of(2);
  trace.time = {0, 1, 2, 3, 4, 5};
  trace.velocity.assign(6, {0, 0});
  trace.force = {{0}, {0}, {0}, {1}, {1.00001}, {1}};
  BOOST_TEST(has(report::plot(impact_of(trace), "").data, "1,0,0\n1,2,0\n1,3,1\n1,5,1\n"));
}

BOOST_AUTO_TEST_CASE(phases_are_shaded_between_events_the_darker_the_more_contacts_are_closed) {
  auto impact = impact_of(trace_of(3));
  impact.events = {{0, {}, {0, 1}}, {2e-5, {0}, {}}, {4e-5, {1}, {}}};
  const auto script = report::plot(impact, "").script;
  BOOST_TEST(has(script, "rectangle from 0, graph 0 to 20, graph 1 behind fillcolor rgb '#e6ecf3'"));
  BOOST_TEST(has(script, "rectangle from 20, graph 0 to 40, graph 1 behind fillcolor rgb '#f1f4f8'"));
  BOOST_TEST(!has(script, "rectangle from 40"));
  BOOST_TEST(has(script, "1–2 close}' at graph"));
  BOOST_TEST(has(script, "2 opens}' at graph"));
}

BOOST_AUTO_TEST_CASE(bodies_that_touch_at_rest_close_if_they_are_pressed) {
  using model::BodyEvent;
  impact::BodiesImpact impact;
  impact.dimension = 2;
  for (const double time : {0.0, 5e-5}) {
    impact.trace.time.push_back(time);
    impact.trace.body.emplace_back(4);
    impact.trace.gap.emplace_back(3, 0.0);
    impact.trace.force.emplace_back(3, 2e4);
  }
  impact::BodiesEvents start{.time = 0};
  start.all[static_cast<std::size_t>(BodyEvent::close)] = {1};
  start.all[static_cast<std::size_t>(BodyEvent::touch)] = {0, 2};
  start.all[static_cast<std::size_t>(BodyEvent::part)] = {2};
  impact.events = {start};
  BOOST_TEST(has(report::plot(impact, "").script, " 1–2 close}"));
}

BOOST_AUTO_TEST_CASE(no_event_loses_its_words_events_that_are_near_share_them) {
  auto impact = impact_of(trace_of(6));
  impact.events = {{0, {}, {0, 1, 2, 3, 4}}, {2e-5, {2}, {}},    {2.01e-5, {1}, {}},
                   {2.02e-5, {0}, {}},       {2.03e-5, {3}, {}}, {2.04e-5, {}, {0}}};
  const auto script = report::plot(impact, "").script;
  BOOST_TEST(has(script, "1–5 close}' at graph"));
  BOOST_TEST(has(script, " 3 opens}' at graph"));
  BOOST_TEST(has(script, " 2 opens … 1 closes}' at graph"), script);
}

BOOST_AUTO_TEST_CASE(contacts_that_open_at_different_times_are_told_one_by_one) {
  auto impact = impact_of(trace_of(6));
  impact.events = {{2e-5, {2}, {}}, {2.01e-5, {1}, {}}, {2.02e-5, {0}, {}}};
  BOOST_TEST(has(report::plot(impact, "").script, " 2 opens, 1 opens}' at graph"));
}

BOOST_AUTO_TEST_CASE(words_of_many_changes_are_the_first_and_the_last) {
  auto impact = impact_of(trace_of(3));
  for (int i = 0; i < 6; ++i) impact.events.push_back({2e-5 + 1e-8 * i, {i % 2}, {1 - i % 2}});
  const auto marks = [&](double width) {
    return report::event_marks(impact.events, {1e6, "µs", 0}, {0, 5e-5}, width, 20);
  };
  BOOST_TEST(has(marks(200), "1 closes … 2 opens}"), marks(200));
  BOOST_TEST(count(marks(200), " closes") == 2u);
  BOOST_TEST(!has(marks(40), "closes"));  // wider than the panel
}

BOOST_AUTO_TEST_CASE(words_of_events_stay_off_the_numbers_of_the_axis_and_off_the_next_panel) {
  auto impact = impact_of(trace_of(3));
  impact.events = {{0, {}, {0}}, {5e-5, {0}, {}}};
  const auto marks = [&](std::optional<double> room) {
    return report::event_marks(impact.events, {1e6, "µs", 0}, {0, 5e-5}, 200, room);
  };
  const double half = 0.5 * 9 * 5.2 / 200;  // of "1 closes" and a blank, in lengths of the axis
  BOOST_TEST(has(marks(0), fmt::format("closes}}' at graph {:.4f}", half)));
  BOOST_TEST(has(marks(0), fmt::format("opens}}' at graph {:.4f}", 1 - 0.5 * 8 * 5.2 / 200)));
  BOOST_TEST(has(marks(40), "opens}' at graph 1.0000"));
  BOOST_TEST(!has(marks({}), "closes"));
}

BOOST_AUTO_TEST_CASE(events_of_images_are_ticks_above_them) {
  auto impact = impact_of(trace_of(14));
  impact.events = {{2e-5, {}, {0}}};
  const auto script = report::plot(impact, "").script;
  BOOST_TEST(count(script, "set arrow from 20, graph 1 to 20, graph 1.025 nohead front") == 2 * terminals);
  BOOST_TEST(!has(script, "rectangle"));
}

BOOST_AUTO_TEST_CASE(components_of_a_body_that_are_zero_throughout_are_left_out) {
  impact::MicrobodyImpact impact;
  for (const double time : {0.0, 1e-7}) {
    auto& state = impact.trace.state.emplace_back();
    state.time = time;
    state.velocity = {-1, 0, 2};
    impact.trace.gap.push_back({0});
    impact.trace.normal_force.push_back({1});
    impact.trace.friction.push_back({{0, 0, time}});
  }
  const auto script = report::plot(impact, "").script;
  for (const char* name : {"'along e_3'", "'tip 1 normal'", "'tip 1 e_3'"})
    BOOST_TEST(has(script, name), name);
  for (const char* name : {"along e_2", "tip 1 e_2"}) BOOST_TEST(!has(script, name), name);
}

BOOST_AUTO_TEST_CASE(many_events_are_ticks_without_words) {
  auto impact = impact_of(trace_of(3));
  for (int i = 0; i < 25; ++i) impact.events.push_back({1e-6 * i, {}, {0}});
  const auto script = report::plot(impact, "").script;
  BOOST_TEST(!has(script, "closes"));
  BOOST_TEST(!has(script, "rectangle"));
  BOOST_TEST(count(script, "graph 1 to") == 2 * terminals * 25);
}
