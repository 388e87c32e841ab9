#define BOOST_TEST_MODULE report_table
#include <boost/test/unit_test.hpp>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/table/table.hpp"
#include "report/three_balls.hpp"
#include "support/lines.hpp"

using namespace mariotte;
using support::lines;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::pair<impact::ChainImpact, scene::Scene> long_chain(std::size_t balls) {
  impact::ChainImpact impact;
  scene::Scene scene;
  scene.model = model::Chain{.mass = std::vector(balls, 1e-3),
                             .law = std::vector<contact::Law>(balls - 1, contact::Hertz{1e9}),
                             .gap = std::vector(balls - 1, 0.0),
                             .velocity = std::vector(balls, 0.0)};
  impact.time = 1.2345678e-3;
  impact.velocity.assign(balls, -1.2345678);
  impact.gap.assign(balls - 1, 0);
  impact.contacts.assign(balls - 1, {.impulse = 0.0123456789,
                                     .peak_force = 12345.678,
                                     .peak_indentation = 1.2345678e-5,
                                     .dissipated = 1.2345678e-6,
                                     .periods = {{0, 1e-4}, {1.2345678e-4, 1.2345678e-3}, {1.23e-3, {}}},
                                     .meeting = {1.2345678, 1.2345678}});
  impact.icr.assign(balls - 2, 1.0768);
  impact.events.assign(3 * balls, {.time = 1e-4, .open = {0, 1, 2}, .close = {5, 7, 8}});
  return {impact, scene};
}

}  // namespace

BOOST_AUTO_TEST_CASE(table_says_how_the_run_ended_and_why) {
  const auto text = report::table(support::three_balls_impact(), support::three_balls());
  BOOST_TEST(text.starts_with("Three balls\n"));
  BOOST_TEST(has(text, "time_limit at 4.0000000 s"));
  BOOST_TEST(has(text, "the time limit of 4 s was reached"));
}

BOOST_AUTO_TEST_CASE(table_says_that_gravity_brings_balls_back) {
  auto [impact, scene] = long_chain(3);
  auto& chain = std::get<model::Chain>(scene.model);
  BOOST_TEST(!has(report::table(impact, scene), "gravity"));
  chain.mass[0] = infinity;
  chain.gravity = 9.81;
  BOOST_TEST(has(report::table(impact, scene), "gravity brings balls back to the wall"));
  impact.ending = hybrid::Ending::time_limit;
  BOOST_TEST(!has(report::table(impact, scene), "gravity"));
}

BOOST_AUTO_TEST_CASE(table_says_of_what_is_bound_when_its_numbers_are) {
  auto [impact, scene] = long_chain(3);
  impact.ending = hybrid::Ending::bound;
  impact.bound_frequency = {1e6};
  const auto text = report::table(impact, scene);
  BOOST_TEST(has(text, "rings on at 1e+06 Hz\nall numbers are those of this instant; run.until"), text);
}

BOOST_AUTO_TEST_CASE(table_shows_every_part_of_the_result) {
  auto impact = support::three_balls_impact();
  impact.validity.contact_radius_ratio = impact::Extreme{0.25, 1};
  impact.validity.peak_pressure = impact::Extreme{1.5e9, 0};
  const auto text = report::table(impact, support::three_balls(), report::Detail::full);
  for (const char* part :
       {"Validity\n", "max a/R     0.25        2   ≤ 0.1     no", "max p₀ [Pa]  1.5e+09        1", "Events",
        "Balls", "Contacts", "Impulse correlation ratios", "undefined", "Energy [J]", "(relative 2.0e-17)",
        "Momentum [N s]", "cvode-adams", "mass matrix", "stored"})
    BOOST_TEST(has(text, part), part);
}

BOOST_AUTO_TEST_CASE(what_was_not_needed_is_told_in_full_only) {
  const auto text = report::table(support::three_balls_impact(), support::three_balls());
  for (const char* part : {"Flows", "Not needed", "Validity"}) BOOST_TEST(!has(text, part), part);
}

BOOST_AUTO_TEST_CASE(table_numbers_contacts_from_one) {
  const auto text = lines(report::table(support::three_balls_impact(), support::three_balls()));
  const auto at = std::find(text.begin(), text.end(), "Events");
  BOOST_TEST(at[2] == "  0.0000000               1");
  BOOST_TEST(at[3] == "  0.5000000               2              1");
}

BOOST_AUTO_TEST_CASE(table_of_a_long_chain_is_short_and_narrow) {
  const auto [impact, scene] = long_chain(100000);
  const auto text = report::table(impact, scene);
  BOOST_TEST(lines(text).size() < 250);
  BOOST_TEST(has(text, "⋮ 99964 more"));
  for (const auto& line : lines(text)) BOOST_TEST(report::width(line) <= 100);
}

BOOST_AUTO_TEST_CASE(scene_table_names_walls_laws_and_limits) {
  const auto text = report::table(support::three_balls());
  for (const char* part :
       {"2 balls and 1 wall", "plane", "hertz", "viscoelastic", "time limit none", "flow auto"})
    BOOST_TEST(has(text, part), part);
  BOOST_TEST(!has(text, "other numbers"));
}

BOOST_AUTO_TEST_CASE(consecutive_numbers_are_joined) {
  BOOST_TEST(report::numbers({}) == "");
  BOOST_TEST(report::numbers({0}) == "1");
  BOOST_TEST(report::numbers({0, 1, 2, 5}) == "1–3 6");
  BOOST_TEST(report::numbers({0, 2, 4, 6, 8, 10, 12}) == "1 3 5 7 … 13 (7 in all)");
}

BOOST_AUTO_TEST_CASE(width_counts_characters_not_bytes) {
  BOOST_TEST(report::width("time [µs]") == 9);
}
