#define BOOST_TEST_MODULE report_sweep_plot
#include <stdlib.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "mariotte/report/figure/drawn_axes.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/sweep_axes.hpp"
#include "mariotte/report/figure/sweep_plot.hpp"
#include "mariotte/report/page/files.hpp"

using namespace mariotte;
using study::Design;
namespace fs = std::filesystem;

namespace {

study::Parameter ranged(const std::string& key, Index axis, study::Range range) {
  return {.key = key, .axis = axis, .range = range};
}

Design curve(Index count) {
  return {.parameters = {ranged("a", 0, {.from = 0, .to = 1})}, .axes = {{.count = count, .stride = 1}}};
}

Design map(Index along_x, Index along_y) {
  return {.parameters = {ranged("a", 0, {.from = 0.1, .to = 10, .logarithmic = true}),
                         ranged("b", 1, {.from = 0, .to = 1})},
          .axes = {{.count = along_x, .stride = along_y}, {.count = along_y, .stride = 1}}};
}

Design cloud(Index count) {
  return {.parameters = {ranged("a", 0, {.from = 0, .to = 1, .seed = 1}),
                         ranged("b", 0, {.from = 0, .to = 1, .seed = 1})},
          .axes = {{.count = count, .stride = 1}}};
}

study::Parameter listed(const std::string& key, Index axis, const std::vector<double>& values) {
  study::Parameter one{.key = key, .axis = axis};
  for (const double value : values) one.list.emplace_back().value = value;
  return one;
}

/// A short list beside a range, whichever is the slower one.
Design family(bool list_first) {
  const Index slow = list_first ? 0 : 1, count = list_first ? 3 : 20;
  return {.parameters = {listed("surface.friction", slow, {0, 0.15, 0.7}),
                         ranged("b", 1 - slow, {.from = 0, .to = 1})},
          .axes = {{.count = count, .stride = 60 / count}, {.count = 60 / count, .stride = 1}}};
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

/// What gnuplot made of a sweep, and its complaint.
struct Drawing {
  std::string svg;  ///< the first figure
  std::string problem;
};

std::string content(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Of a sweep with one row per point; the cells of every other point may differ.
Drawing drawing(const Design& design, const std::vector<study::Column>& columns, const std::string& cells,
                std::string others = "", const scene::Figure& options = {}) {
  if (others.empty()) others = cells;
  std::string folder = (fs::temp_directory_path() / "mariotte-XXXXXX").string();
  ::mkdtemp(folder.data());
  std::string rows, data;
  for (Index point = 0; point < design.points(); ++point)
    rows += std::string(design.parameters.size(), ',') + (point % 2 == 0 ? cells : others) + "\n";
  report::append_drawn(design, 0, rows, data);
  const auto plot = report::sweep_plot(design, columns, "It's a title", options);
  report::write_file(fs::path(folder) / "plot.csv", data);
  report::write_file(fs::path(folder) / "plot.gp", plot.script);
  Drawing made{.svg = {}, .problem = report::draw(folder, plot.figures)};
  for (const auto& figure : plot.figures)
    if (made.problem.empty() && fs::file_size(fs::path(folder) / figure) < 1000)
      made.problem = figure + " is empty";
  if (made.problem.empty()) made.svg = content(fs::path(folder) / plot.figures[2]);
  fs::remove_all(folder);
  if (made.problem == "gnuplot is not installed") made.problem.clear();
  return made;
}

using Columns = std::vector<study::Column>;

std::string drawn(const Design& design, const Columns& columns, const std::string& cells,
                  const std::string& others = "", const scene::Figure& options = {}) {
  return drawing(design, columns, cells, others, options).problem;
}

}  // namespace

BOOST_AUTO_TEST_CASE(curves_of_one_quantity_share_a_figure_and_maps_do_not) {
  const std::vector<study::Column> columns = {{"final.velocity[0]"}, {"icr[0]"}, {"final.velocity[1]"}};
  BOOST_TEST(report::sweep_plot(curve(5), columns, "").figures ==
                 (std::vector<std::string>{"sweep.final.velocity.pdf", "sweep.final.velocity.png",
                                           "sweep.final.velocity.svg", "sweep.icr.pdf", "sweep.icr.png",
                                           "sweep.icr.svg"}),
             boost::test_tools::per_element());
  BOOST_TEST(report::sweep_plot(map(3, 3), columns, "").figures.size() == 9);
  BOOST_TEST(report::sweep_plot(map(3, 3), columns, "").figures[3] == "sweep.icr_0.pdf");
}

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
BOOST_AUTO_TEST_CASE(names_of_columns_stay_in_their_quotes_and_out_of_paths) {
  const std::string bad = "x'; set print 'y";
  const Columns columns = {{.key = bad, .unit = "m/s", .written = "="},
                           {.key = "../a/b", .written = "="},
                           {.key = "../a b", .written = "="},
                           {.key = "100 %d `date`", .unit = "m/s", .written = "="},
                           {.key = std::string(300, 'n'), .written = "="},
                           {.key = "two\nlines", .written = "="}};
  for (const auto& design : {curve(5), map(3, 3)}) {
    const auto plot = report::sweep_plot(design, columns, "");
    BOOST_TEST(plot.script.find("'x''; set print ''y") != std::string::npos);
    BOOST_TEST(plot.script.find("x'; ") == std::string::npos);
    BOOST_TEST(plot.figures[0] == "sweep.x___set_print__y.pdf");
    BOOST_TEST(plot.figures[3] == "sweep..._a_b.pdf");
    BOOST_TEST(plot.figures[6] == "sweep..._a_b_2.pdf");
    BOOST_TEST(drawn(design, columns, "1,2,3,4,5,6,separated,", "2,3,4,5,6,7,separated,") == "");
  }
}

BOOST_AUTO_TEST_CASE(figures_are_as_wide_as_a_column_and_names_beside_lines_where_they_fit) {
  Columns columns;
  for (int i = 0; i < 10; ++i) columns.push_back({"final.velocity[" + std::to_string(i) + "]", "m/s", "v_i"});
  const auto beside = report::sweep_plot(curve(5), columns, "").script;
  columns.push_back({"final.velocity[10]", "m/s", "v_i"});
  const auto below = report::sweep_plot(curve(5), columns, "").script;
  for (const auto& text : {beside, below, report::sweep_plot(map(3, 3), columns, "").script}) {
    BOOST_TEST(text.find("pdfcairo size 8.60cm,") != std::string::npos);
    BOOST_TEST(text.find("pdfcairo size 12") == std::string::npos);
  }
  BOOST_TEST(beside.find("set label 'v_{10}' at graph") != std::string::npos);
  BOOST_TEST(beside.find("set key below") == std::string::npos);
  BOOST_TEST(below.find("set key below") != std::string::npos);
  BOOST_TEST(drawn(curve(5), {{"long_name_of_a_column"}}, "1,separated,") == "");
}

// The ends of v_1 and v_3 are close; v_2 lies between them.
BOOST_AUTO_TEST_CASE(names_keep_the_order_of_the_ends) {
  const Columns columns = {
      {"x[0]", "1", "v_i"}, {"x[1]", "1", "v_i"}, {"x[2]", "1", "v_i"}, {"x[3]", "1", "v_i"}};
  const auto svg = drawing(curve(5), columns, "1,1.002,1.001,9,separated,").svg;
  const std::regex name(R"~(translate\([0-9.]+,([0-9.]+)\)"[^>]*"start">\s*<text><tspan [^>]*>v)~");
  std::vector<double> height;
  for (std::sregex_iterator one(svg.begin(), svg.end(), name), end; one != end; ++one)
    height.push_back(std::stod((*one)[1]));
  if (svg.empty()) return;  // no gnuplot
  BOOST_TEST_REQUIRE(height.size() == 4u);
  BOOST_TEST((height[0] > height[2] + 10 && height[2] > height[1] + 10 && height[1] > height[3]));
}

BOOST_AUTO_TEST_CASE(what_has_no_figure_is_said) {
  auto three = map(2, 2);
  three.parameters.push_back(ranged("c", 2, {.from = 0, .to = 1}));
  three.axes = {{.count = 2, .stride = 4}, {.count = 2, .stride = 2}, {.count = 2, .stride = 1}};
  const auto none = report::sweep_plot(three, {{"icr[0]"}}, "");
  BOOST_TEST((none.figures.empty() && !none.shortfall.empty()));
  std::vector<study::Column> many;
  for (int i = 0; i < 20; ++i) many.push_back({"contacts[" + std::to_string(i) + "].impulse"});
  const auto some = report::sweep_plot(map(2, 2), many, "");
  BOOST_TEST((some.figures.size() == 36 && some.shortfall == "only the first 12 are drawn"));
  BOOST_TEST(report::sweep_plot(curve(2), many, "").shortfall == "");
}

BOOST_AUTO_TEST_CASE(a_logarithmic_axis_shows_logarithms_with_the_values_beside_it) {
  BOOST_TEST(report::coordinate(map(3, 2), 0, 2) == 0, boost::test_tools::tolerance(1e-12));
  const auto axis = report::axis_settings(map(3, 2), 0, 'x');
  BOOST_TEST(axis.find("'0.1' -1, ") != std::string::npos, axis);
  BOOST_TEST(axis.find("'10' 1)") != std::string::npos, axis);
}

BOOST_AUTO_TEST_CASE(a_large_map_is_thinned_out_evenly) {
  const auto design = map(1000, 500);
  std::string rows, data;
  for (Index point = 0; point < design.points(); ++point) rows += std::to_string(point) + "\n";
  report::append_drawn(design, 0, rows, data);
  auto all = lines(data);
  BOOST_TEST(std::erase(all, "") == 200u);  // columns
  BOOST_TEST_REQUIRE(all.size() == 200u * 167u);
  BOOST_TEST(all[1].ends_with(",3"));
  BOOST_TEST(all[167].ends_with(",2500"));
  std::string in_parts;
  report::append_drawn(design, 0, rows.substr(0, rows.find("\n1000\n") + 1), in_parts);
  report::append_drawn(design, 1000, rows.substr(rows.find("\n1000\n") + 1), in_parts);
  BOOST_TEST((in_parts == data));
}

BOOST_AUTO_TEST_CASE(gnuplot_draws_every_kind_of_sweep) {
  for (const auto& design : {curve(10), map(4, 3), map(2, 9), cloud(30)}) {
    BOOST_TEST(drawn(design, {{"x[0]"}, {"x[1]", "N s", "x'_j"}, {"y"}}, "1,2,3,separated,") == "");
    BOOST_TEST(drawn(design, {{"x[0]"}, {"x[1]", "N s", "x'_j"}, {"y"}}, "1,,,separated,") == "");
    for (const auto* others : {",2,,separated,", ",,,rejected,\"no, not this\""}) {
      BOOST_TEST(drawn(design, {{"x[0]"}, {"x[1]", "N s", "x'_j"}, {"y"}}, "1,,3,separated,", others) == "");
      BOOST_TEST(drawn(design, {{"x[0]"}, {"x[1]", "N s", "x'_j"}, {"y"}}, others, "1,,3,separated,") == "");
    }
  }
  Design listed = curve(2);
  listed.parameters[0].range.reset();
  listed.parameters[0].list = {{.value = "it's", .place = {}}, {.value = true, .place = {}}};
  BOOST_TEST(drawn(listed, {{"x"}}, "1,separated,") == "");
}

BOOST_AUTO_TEST_CASE(a_short_list_beside_another_axis_is_a_curve_per_value) {
  for (const bool list_first : {true, false}) {
    const auto design = family(list_first);
    const auto text = report::sweep_plot(design, {{"y", "N", "y"}}, "").script;
    BOOST_TEST(text.find("set xlabel 'b'") != std::string::npos, text);
    BOOST_TEST(text.find("set label 'friction μ' at graph") != std::string::npos, text);
    BOOST_TEST(text.find("using 1:($2 == 1 && ") != std::string::npos);
    BOOST_TEST(text.find("set label '0.15' at graph") != std::string::npos);
    BOOST_TEST(text.find("with image") == std::string::npos);
    BOOST_TEST((text.find("every 3::1") == std::string::npos) == list_first);
    const auto svg = drawing(design, {{"y", "N", "y"}}, "2,separated,", "1,separated,").svg;
    BOOST_TEST((svg.empty() || svg.find(">0.15<") != std::string::npos));
  }
}

/// Pieces of the second line in an SVG.
std::size_t pieces(const std::string& svg) {
  const std::string second = "<path stroke='rgb(  0, 114, 178)'";
  std::size_t found = 0;
  for (auto at = svg.find(second); at != svg.npos; at = svg.find(second, at + 1)) {
    const auto path = svg.substr(at, svg.find("/>", at) - at);
    found += path.find(" L") != path.npos
                 ? static_cast<std::size_t>(std::count(path.begin(), path.end(), 'M'))
                 : 0;
  }
  return found;
}

BOOST_AUTO_TEST_CASE(no_line_joins_points_of_different_endings_or_counts) {
  const Columns columns = {{"y"}, {"impacts.count", "1"}};
  for (const bool list_first : {true, false}) {
    const auto svg = [&](const char* cells, const char* others) {
      return drawing(family(list_first), columns, cells, others).svg;
    };
    const auto whole = svg("2,1,separated,", "1,1,separated,");
    if (whole.empty()) continue;  // no gnuplot
    BOOST_TEST(pieces(whole) == 1u);
    BOOST_TEST(pieces(svg("2,1,separated,", "1,1,captured,")) == 0u);  // all points are alone
    BOOST_TEST(pieces(svg("2,1,separated,", "1,2,separated,")) == 0u);
  }
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

BOOST_AUTO_TEST_CASE(maps_have_contours_and_logarithmic_colours_on_demand) {
  const auto plain = report::sweep_plot(map(4, 4), {{"y"}}, "").script;
  BOOST_TEST(plain.find("contour base") == std::string::npos);
  BOOST_TEST(plain.find("logscale cb") == std::string::npos);
  const auto lined =
      report::sweep_plot(map(4, 4), {{"y"}}, "", {.window = {}, .logarithmic = true, .contours = 5}).script;
  BOOST_TEST(lined.find("set cntrparam levels auto 5") != std::string::npos);
  BOOST_TEST(lined.find("set logscale cb") != std::string::npos);
  const scene::Figure options{.window = {}, .logarithmic = true, .contours = 5};
  for (const auto& design : {curve(10), map(2, 1), cloud(30)})
    BOOST_TEST(drawn(design, {{"y"}}, "2,separated,", "1,separated,", options) == "");
  for (const auto* others : {"1,separated,", ",rejected,no", "-3,separated,"})
    BOOST_TEST(drawn(map(8, 9), {{"y"}}, "2,separated,", others, options) == "");
}

/// Where words that begin with "1." stand in an SVG that are smaller than those of axes.
std::vector<std::pair<double, double>> small_words(const std::string& svg) {
  const std::regex word(
      R"~(translate\(([0-9.]+),([0-9.]+)\)"[^>]*"middle">\s*<text><tspan [^>]*font-size="10[^>]*>1\.)~");
  std::vector<std::pair<double, double>> all;
  for (std::sregex_iterator one(svg.begin(), svg.end(), word), end; one != end; ++one)
    all.emplace_back(std::stod((*one)[1]), std::stod((*one)[2]));
  return all;
}

BOOST_AUTO_TEST_CASE(names_of_contours_do_not_cover_each_other) {
  const scene::Figure options{.window = {}, .logarithmic = false, .contours = 20};
  const auto svg = drawing(map(30, 30), {{"y"}}, "2,separated,", "1,separated,", options).svg;
  const auto all = small_words(svg);
  BOOST_TEST((svg.empty() || all.size() > 1), svg.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      BOOST_TEST(
          (std::abs(all[i].first - all[k].first) > 25 || std::abs(all[i].second - all[k].second) > 12));
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
  design.parameters[0].unit = "1";
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

BOOST_AUTO_TEST_CASE(logarithmic_colours_have_several_ticks_at_round_values) {
  const scene::Figure options{.window = {}, .logarithmic = true, .contours = 0};
  const auto text = drawing(map(8, 9), {{"y"}}, "0.7,separated,", "3,separated,", options).svg;
  BOOST_TEST((text.empty() || text.find(">2<") != std::string::npos), text);
  BOOST_TEST((text.empty() || text.find(">1<") != std::string::npos), text);
}

BOOST_AUTO_TEST_CASE(values_have_a_prefix_that_suits_what_is_shown) {
  const auto text =
      drawing(curve(4), {{"contacts[0].impulse", "N s", "p_j"}}, "2e-6,separated,", "3e-6,separated,").svg;
  BOOST_TEST((text.empty() || text.find("[µN s]") != std::string::npos), text);
}

BOOST_AUTO_TEST_CASE(labels_beside_a_map_are_within_its_sheet) {
  const auto text =
      drawing(map(4, 3), {{"icr[0]", "1", "α_j"}}, "0.99265,separated,", "0.99635,separated,").svg;
  const std::regex turned(R"(translate\(([0-9.-]+),[0-9.-]+\) rotate\(270)");
  std::vector<double> places;
  for (std::sregex_iterator one(text.begin(), text.end(), turned), end; one != end; ++one)
    places.push_back(std::stod((*one)[1]));
  BOOST_TEST((text.empty() || places.size() == 2));
  for (const double place : places) {
    BOOST_TEST(place > 13);  // the height of letters
    BOOST_TEST(place < report::one_column.width - 4);
  }
}
