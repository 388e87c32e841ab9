#define BOOST_TEST_MODULE report_sweep_plot
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <regex>

#include "support/drawn_sweeps.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// A short list beside a range, whichever is the slower one.
Design family(bool list_first) {
  const Index slow = list_first ? 0 : 1, count = list_first ? 3 : 20;
  return {.parameters = {listed("surface.friction", slow, {0, 0.15, 0.7}),
                         ranged("b", 1 - slow, {.from = 0, .to = 1})},
          .axes = {{.count = count, .stride = 60 / count}, {.count = 60 / count, .stride = 1}}};
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
