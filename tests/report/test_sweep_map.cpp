#define BOOST_TEST_MODULE report_sweep_map
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <regex>

#include "support/drawn_sweeps.hpp"
#include "support/lines.hpp"

using namespace mariotte;
using support::lines;
using namespace mariotte::test;

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

BOOST_AUTO_TEST_CASE(logarithmic_colours_have_several_ticks_at_round_values) {
  const scene::Figure options{.window = {}, .logarithmic = true, .contours = 0};
  const auto text = drawing(map(8, 9), {{"y"}}, "0.7,separated,", "3,separated,", options).svg;
  BOOST_TEST((text.empty() || text.find(">2<") != std::string::npos), text);
  BOOST_TEST((text.empty() || text.find(">1<") != std::string::npos), text);
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
