#define BOOST_TEST_MODULE report_json
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "mariotte/report/json/json.hpp"
#include "report/three_balls.hpp"

using namespace mariotte;

namespace {

std::vector<std::string> keys(const report::Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

report::Json example() {
  return report::json(support::three_balls_impact(), support::three_balls());
}

void check_keys(const report::Json& object, const std::vector<std::string>& expected) {
  const auto found = keys(object);
  BOOST_CHECK_EQUAL_COLLECTIONS(found.begin(), found.end(), expected.begin(), expected.end());
}

}  // namespace

BOOST_AUTO_TEST_CASE(result_has_the_promised_keys_in_order) {
  check_keys(example(), {"ending", "title", "model", "message", "final", "contacts", "bound_frequency", "icr",
                         "impulse_direction", "events", "energy", "momentum", "validity", "accuracy", "flows",
                         "skipped", "provenance"});
}

BOOST_AUTO_TEST_CASE(parts_of_the_result_have_the_promised_keys) {
  const auto result = example();
  check_keys(result["final"], {"time", "velocity", "gap"});
  check_keys(result["contacts"][0],
             {"impulse", "peak_force", "peak_indentation", "approach_speed", "separation_speed", "periods",
              "stored", "dissipated", "plastic_work", "adhesion_loss", "permanent_indentation"});
  check_keys(result["events"][0], {"time", "open", "close", "yield", "unload", "stick", "slip", "capture"});
  check_keys(result["energy"], {"initial", "final", "stored", "dissipated", "plastic_work", "adhesion_loss",
                                "work", "residual", "ratio_lab", "ratio_centre"});
  check_keys(result["momentum"], {"initial", "final", "residual"});
  check_keys(result["accuracy"], {"requested", "estimated"});
  check_keys(result["flows"][0], {"name", "phases", "steps", "rhs"});
  check_keys(result["provenance"], {"version", "scene_sha256", "sundials", "compiler", "build_type"});
}

BOOST_AUTO_TEST_CASE(events_name_contacts_from_one) {
  const auto events = example()["events"];
  BOOST_TEST(events[1]["open"] == report::Json::array({1}));
  BOOST_TEST(events[1]["close"] == report::Json::array({2}));
  BOOST_TEST(events[1]["stick"] == report::Json::array());
}

BOOST_AUTO_TEST_CASE(what_is_undefined_or_not_over_is_null) {
  const auto result = example();
  BOOST_TEST(result["icr"][0].is_null());
  BOOST_TEST(result["accuracy"]["estimated"].is_null());
  BOOST_TEST(result["energy"]["ratio_lab"].is_null());
  BOOST_TEST(result["contacts"][1]["periods"][0][1].is_null());
  BOOST_TEST(result["contacts"][0]["periods"][0][1] == 3.0);
}

BOOST_AUTO_TEST_CASE(a_separated_run_has_no_message_and_a_clean_scene_no_warnings) {
  auto impact = support::three_balls_impact();
  impact.ending = hybrid::Ending::separated;
  impact.message.clear();
  const auto result = report::json(impact, support::three_balls());
  BOOST_TEST(result["ending"] == "separated");
  BOOST_TEST(!result.contains("message"));
  BOOST_TEST(!result.contains("warnings"));
}

BOOST_AUTO_TEST_CASE(a_limit_is_explained_even_if_the_run_is_silent) {
  auto impact = support::three_balls_impact();
  impact.message.clear();
  auto scene = support::three_balls();
  scene.run.max_time = 4;
  BOOST_TEST(report::json(impact, scene)["message"] == "max_time = 4 s was reached before the end");
}

BOOST_AUTO_TEST_CASE(warnings_of_the_scene_are_kept) {
  auto scene = support::three_balls();
  scene.warnings = {"a.toml:3:1: suspicious"};
  BOOST_TEST(report::json(support::three_balls_impact(), scene)["warnings"][0] == scene.warnings[0]);
}

BOOST_AUTO_TEST_CASE(numbers_have_seventeen_significant_digits) {
  const report::Json numbers = {
      {"tenth", 0.1}, {"third", 1.0 / 3}, {"one", 1.0}, {"count", 7}, {"tiny", 1e-300}};
  const std::string text = report::text(numbers);
  BOOST_TEST(text.find("\"tenth\": 0.10000000000000001,") != std::string::npos);
  BOOST_TEST(text.find("\"third\": 0.33333333333333331,") != std::string::npos);
  BOOST_TEST(text.find("\"one\": 1.0,") != std::string::npos);
  BOOST_TEST(text.find("\"count\": 7,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(text_gives_back_the_same_doubles) {
  auto impact = support::three_balls_impact();
  impact.velocity = {0.1, -1.0 / 3, 4.9e-324, 1.7976931348623157e308, -0.0, 2};
  const auto parsed = report::Json::parse(report::text(report::json(impact, support::three_balls())));
  const auto velocity = parsed["final"]["velocity"].get<std::vector<double>>();
  BOOST_TEST(velocity == impact.velocity, boost::test_tools::per_element());
  BOOST_TEST(std::signbit(velocity[4]));
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_become_null) {
  auto impact = support::three_balls_impact();
  impact.velocity = {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
  const auto parsed = report::Json::parse(report::text(report::json(impact, support::three_balls())));
  for (const auto& velocity : parsed["final"]["velocity"]) BOOST_TEST(velocity.is_null());
}

BOOST_AUTO_TEST_CASE(any_title_gives_valid_json) {
  auto scene = support::three_balls();
  scene.title = "quote \" backslash \\ line\n tab\t bell\a umlaut ü broken \xff";
  const auto parsed = report::Json::parse(report::text(report::json(support::three_balls_impact(), scene)));
  BOOST_TEST(
      parsed["title"].get<std::string>().starts_with("quote \" backslash \\ line\n tab\t bell\a umlaut ü"));
}

BOOST_AUTO_TEST_CASE(a_scene_is_shown_with_all_parameters_and_walls_as_null) {
  const auto scene = report::Json::parse(report::text(report::json(support::three_balls())));
  check_keys(scene, {"title", "model", "chain", "run", "provenance"});
  check_keys(scene["chain"], {"mass", "velocity", "gap", "contact", "gravity", "precompressed", "radius"});
  BOOST_TEST(scene["chain"]["mass"][2].is_null());
  BOOST_TEST(scene["chain"]["contact"][0]["law"] == "hertz");
  BOOST_TEST(scene["chain"]["contact"][1]["damping"] == 0.1);
  BOOST_TEST(scene["run"]["max_time"].is_null());
}
