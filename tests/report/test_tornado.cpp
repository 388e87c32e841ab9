// Bars of relative slopes: the longest first, and none where nothing can be told.
#define BOOST_TEST_MODULE tornado
#include <boost/test/unit_test.hpp>

#include "mariotte/report/figure/tornado.hpp"

using namespace mariotte;

namespace {

impact::Sensitivity two_outcomes() {
  impact::Sensitivity slopes;
  slopes.parameter = {{"mass[0]", 2}, {"mass[1]", 4}, {"gap[0]", 0}, {"contact[0].stiffness", 10}};
  slopes.outcome = {{"velocity", 0, "m/s", 0.5, {0.1, -0.2, 3.0, std::nullopt}},
                    {"velocity", 1, "m/s", 0.0, {1.0, 1.0, 1.0, 1.0}},
                    {"time", {}, "s", 2.0, {0.0, 0.0, 0.0, -0.1}}};
  return slopes;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bars_are_relative_and_sorted) {
  const auto slopes = two_outcomes();
  const auto bars = report::relative_slopes(slopes, slopes.outcome[0]);
  BOOST_TEST_REQUIRE(bars.size() == 2u);
  BOOST_TEST(bars[0].parameter == "mass[1]");
  BOOST_TEST(std::abs(bars[0].value + 1.6) < 1e-15);
  BOOST_TEST(bars[1].parameter == "mass[0]");
  BOOST_TEST(std::abs(bars[1].value - 0.4) < 1e-15);
  BOOST_TEST(report::relative_slopes(slopes, slopes.outcome[1]).empty());
}

BOOST_AUTO_TEST_CASE(errors_of_runs_are_no_bars) {
  auto slopes = two_outcomes();
  slopes.outcome[0].slope = {1e-11, 1e-12, 0.0, std::nullopt};
  BOOST_TEST(report::relative_slopes(slopes, slopes.outcome[0]).empty());
}

BOOST_AUTO_TEST_CASE(outcomes_that_have_bars_have_a_panel) {
  const auto text = report::tornado_csv(two_outcomes());
  BOOST_TEST(text.starts_with("panel,place,slope [% per %],parameter\n1,1,-1.6"));
  BOOST_TEST(text.find("\n2,1,-0.5,contact[0].stiffness\n") != std::string::npos);
  const auto script = report::tornado_script(two_outcomes(), "Title");
  BOOST_TEST(script.find("final velocity v_{1}") != std::string::npos);
  BOOST_TEST(script.find("final velocity v_{2}") == std::string::npos);
  BOOST_TEST(script.find("final time t") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(panels_of_one_body_say_which_component_they_show) {
  auto slopes = two_outcomes();
  slopes.outcome = {{"bodies[1].velocity", 0, "m/s", 0.5, {0.1, -0.2, 3.0, std::nullopt}},
                    {"bodies[1].velocity", 1, "m/s", 0.5, {0.1, -0.2, 3.0, std::nullopt}}};
  const auto script = report::tornado_script(slopes, "Title");
  for (const char* name : {"body 2: final velocity v_x", "body 2: final velocity v_y"})
    BOOST_TEST(script.find(name) != std::string::npos);
}

// The title of a narrow figure would be cut off with it.
BOOST_AUTO_TEST_CASE(what_bars_are_stands_in_the_title_or_below_a_single_panel) {
  const std::string shown = "% of the outcome per % of the parameter";
  auto slopes = two_outcomes();
  BOOST_TEST(report::tornado_script(slopes, "Title").find("title 'Title: " + shown) != std::string::npos);
  slopes.outcome.resize(1);
  const auto script = report::tornado_script(slopes, "Title");
  BOOST_TEST(script.find("title 'Title' ") != std::string::npos);
  BOOST_TEST(script.find("set xlabel '" + shown) != std::string::npos);
}

BOOST_AUTO_TEST_CASE(without_bars_there_is_no_script) {
  auto slopes = two_outcomes();
  slopes.outcome.resize(2);
  slopes.outcome.erase(slopes.outcome.begin());
  BOOST_TEST(report::tornado_script(slopes, "").empty());
}

BOOST_AUTO_TEST_CASE(what_rounding_leaves_of_a_slope_is_no_bar) {
  auto slopes = two_outcomes();
  slopes.outcome.resize(1);
  for (auto& slope : slopes.outcome[0].slope)
    if (slope) *slope *= 1e-14;
  BOOST_TEST(report::relative_slopes(slopes, slopes.outcome[0]).empty());
}
