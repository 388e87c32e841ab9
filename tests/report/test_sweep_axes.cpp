#define BOOST_TEST_MODULE report_sweep_axes
#include <boost/test/unit_test.hpp>

#include "mariotte/report/figure/sweep_axes.hpp"
#include "support/drawn_sweeps.hpp"

using namespace mariotte;
using namespace mariotte::test;

BOOST_AUTO_TEST_CASE(axes_say_words_symbol_and_unit) {
  const std::vector<study::Column> columns = {
      {"contacts[0].impulse", "N s", "p_j"}, {"contacts[1].impulse", "N s", "p_j"}, {"icr[0]", "1", "α_j"}};
  const auto curves = report::sweep_plot(curve(5), columns, "").script;
  BOOST_TEST(curves.find("set ylabel sprintf('impulse p_j\u00a0[%sN s]', ") != std::string::npos, curves);
  BOOST_TEST(curves.find("set label 'p_{2}' at graph") != std::string::npos);
  const auto maps = report::sweep_plot(map(3, 3), columns, "").script;
  BOOST_TEST(maps.find("set cblabel sprintf('impulse p_{2}\u00a0[%sN s]', ") != std::string::npos);
  BOOST_TEST(maps.find("set cblabel 'impulse correlation ratio α_{1}'") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_is_counted_has_whole_ticks) {
  const std::vector<study::Column> counted = {{"contacts[1].periods.count", "1"}};
  BOOST_TEST(report::sweep_plot(map(3, 3), counted, "").script.find("set cbtics 1 ") != std::string::npos);
  const auto made = drawing(map(3, 3), counted, "1,separated,");
  BOOST_TEST(made.problem.empty(), made.problem);
  for (const char* part : {"0.999", "1.0005"}) BOOST_TEST(made.svg.find(part) == std::string::npos, part);
  BOOST_TEST(drawn(curve(5), counted, "1,separated,", "3,separated,") == "");
}

BOOST_AUTO_TEST_CASE(columns_of_ones_own_keep_their_name) {
  const std::vector<study::Column> columns = {{.key = "my_ratio", .written = "my_ratio = icr[0]"},
                                              {"sensitivity.velocity[2].mass[0]", "kg^-1 m s^-1"}};
  const auto curves = report::sweep_plot(curve(5), columns, "").script;
  BOOST_TEST(curves.find("set ylabel 'my\\_ratio'") != std::string::npos, curves);
  BOOST_TEST(curves.find("set ylabel 'slope ∂v_{3}/∂m_{1}\u00a0[kg^{-1} m s^{-1}]'") != std::string::npos,
             curves);
}

// Names of columns are the user's; a name that leaves its quotes would be a command.

BOOST_AUTO_TEST_CASE(a_logarithmic_axis_shows_logarithms_with_the_values_beside_it) {
  BOOST_TEST(report::coordinate(map(3, 2), 0, 2) == 0, boost::test_tools::tolerance(1e-12));
  const auto axis = report::axis_settings(map(3, 2), 0, 'x');
  BOOST_TEST(axis.find("'0.1' -1, ") != std::string::npos, axis);
  BOOST_TEST(axis.find("'10' 1)") != std::string::npos, axis);
}

BOOST_AUTO_TEST_CASE(an_axis_of_one_point_is_not_drawn) {
  for (const auto& design : {map(1, 9), map(9, 1)}) {
    const auto text = report::sweep_plot(design, {{"y"}}, "").script;
    BOOST_TEST(text.find("with image") == std::string::npos);
    BOOST_TEST(text.find("with linespoints") != std::string::npos);
    BOOST_TEST(drawn(design, {{"y"}}, "2,separated,", "1,separated,") == "");
  }
  BOOST_TEST(report::drawn_parameters(map(1, 9)).front() == 1u);
  BOOST_TEST(drawn(map(1, 1), {{"y"}}, "2,separated,") == "");
}

BOOST_AUTO_TEST_CASE(a_list_of_numbers_is_to_scale_and_joined_where_they_rise) {
  Design design = curve(3);
  design.parameters[0] = listed("chain.gap[0]", 0, {1e-6, 2e-6, 5e-6});
  design.parameters[0].unit = "m";
  BOOST_TEST(report::coordinate(design, 0, 2) == 5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(report::axis_settings(design, 0, 'x').find("nomirror out autofreq\n") != std::string::npos);
  BOOST_TEST(report::sweep_plot(design, {{"y"}}, "").script.find("with linespoints") != std::string::npos);
  std::swap(design.parameters[0].list[0], design.parameters[0].list[1]);
  BOOST_TEST(report::sweep_plot(design, {{"y"}}, "").script.find("with points") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(axes_of_inputs_say_words_symbol_and_unit) {
  auto design = curve(3);
  auto& one = design.parameters[0];
  one.key = "chain.gap[1]";
  BOOST_TEST(report::axis_settings(design, 0, 'x').find("xlabel 'gap g_{2}'\n") != std::string::npos);
  one.unit = "1";
  BOOST_TEST(report::axis_settings(design, 0, 'x').find("xlabel 'gap g_{2}'\n") != std::string::npos);
  one.unit = "m";
  one.range->to = 2e-6;
  BOOST_TEST(report::axis_settings(design, 0, 'x').find("xlabel 'gap g_{2}\u00a0[µm]'\n") !=
             std::string::npos);
  BOOST_TEST(report::coordinate(design, 0, 1) == 1, boost::test_tools::tolerance(1e-12));
  one.is_variable = true;
  BOOST_TEST(report::axis_settings(design, 0, 'x').find("xlabel 'chain.gap[1]\u00a0[µm]'") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(angles_are_in_degrees) {
  auto design = curve(3);
  design.parameters[0].key = "incidence.angles[1]";
  design.parameters[0].unit = "rad";
  design.parameters[0].range->to = std::acos(0.0);
  BOOST_TEST(report::axis_settings(design, 0, 'x').find("xlabel 'angle β\u00a0[deg]'") != std::string::npos);
  BOOST_TEST(report::coordinate(design, 0, 1) == 45, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(numbers_below_a_narrow_range_leave_room_for_each_other) {
  auto design = curve(3);
  design.parameters[0].range = {.from = 9.9, .to = 10.1};
  BOOST_TEST(report::axis_settings(design, 0, 'x').find("out 0.05\n") != std::string::npos);
  BOOST_TEST(report::axis_settings(cloud(3), 0, 'x').find("xrange [0:1]\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(values_have_a_prefix_that_suits_what_is_shown) {
  const auto text =
      drawing(curve(4), {{"contacts[0].impulse", "N s", "p_j"}}, "2e-6,separated,", "3e-6,separated,").svg;
  BOOST_TEST((text.empty() || text.find("[µN s]") != std::string::npos), text);
}
