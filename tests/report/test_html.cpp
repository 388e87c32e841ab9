#define BOOST_TEST_MODULE report_html
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "mariotte/report/page/html.hpp"
#include "mariotte/report/page/html_table.hpp"
#include "mariotte/report/page/html_text.hpp"

using namespace mariotte;
using report::Json;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

bool has(const std::string& text, const std::string& part) {
  return count(text, part) > 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(base64_is_that_of_rfc_4648) {
  BOOST_TEST(report::base64("") == "");
  BOOST_TEST(report::base64("f") == "Zg==");
  BOOST_TEST(report::base64("fo") == "Zm8=");
  BOOST_TEST(report::base64("foobar") == "Zm9vYmFy");
}

BOOST_AUTO_TEST_CASE(text_stands_for_itself) {
  const auto page = report::html({{"title", "<b> & \"c\""}, {"note", "<script>"}}, {{"x\"y", "<svg/>"}});
  BOOST_TEST(has(page, "<title>&lt;b&gt; &amp; &quot;c&quot;</title>"));
  BOOST_TEST(has(page, "&lt;script&gt;"));
  BOOST_TEST(count(page, "<script>") == 1);  // the page's own
  BOOST_TEST(has(page, "alt=\"x&quot;y\""));
  const auto moving = report::html(Json::object(), {}, {{"note", "</script><b>"}});
  BOOST_TEST(has(moving, R"("note":"\u003c/script>\u003cb>")"));
}

BOOST_AUTO_TEST_CASE(the_page_needs_no_other_file) {
  const auto page = report::html({{"title", "t"}}, {{"forces", "<svg></svg>"}});
  BOOST_TEST(has(page, "src=\"data:image/svg+xml;base64,PHN2Zz48L3N2Zz4=\""));
  for (const auto* part : {"http:", "https:", "src=\"/", "url(", "@import", "<script src"})
    BOOST_TEST(!has(page, part), part);
}

BOOST_AUTO_TEST_CASE(every_part_of_a_result_is_on_the_page) {
  const Json result = {{"ending", "captured"},
                       {"title", "A body"},
                       {"model", "microbody"},
                       {"final", {{"time", 0.5}, {"quaternion", {1.0, 0.0, 0.0, 0.0}}}},
                       {"impacts", {{{"tip", 1}, {"start", 0.125}}, {{"tip", 2}, {"start", 0.25}}}},
                       {"restitution", {{"tip", 0.625}, {"centre", nullptr}}},
                       {"energy", {{"initial", 2.0}, {"residual", -4e-10}}},
                       {"something_new", {1, 2, 3}},
                       {"provenance", {{"version", "1.2.3"}, {"scene_sha256", "abc"}}}};
  const auto page = report::html(result, {});
  for (const auto* part : {"captured", ">0.125<", ">0.25<", "0.625", "2.0e-10 of the initial",
                           "something_new", "version = {1.2.3}", "note    = {scene abc}", "@article"})
    BOOST_TEST(has(page, part), part);
  BOOST_TEST(count(page, "<table>") == count(page, "</table>"));
  BOOST_TEST(count(page, "<tr>") == count(page, "</tr>"));
}

BOOST_AUTO_TEST_CASE(a_page_shows_the_scene_file_and_what_is_neglected) {
  const auto page =
      report::html({{"model", "network"}, {"turning", 0.001}, {"scene_text", "[network] # <a>"}}, {});
  BOOST_TEST(has(page, "Neglected: turning of contact directions [rad]"));
  BOOST_TEST(has(page, "<pre>[network] # &lt;a&gt;</pre>"));
}

BOOST_AUTO_TEST_CASE(a_page_cites_what_its_scene_rests_on) {
  const auto chain = report::html({{"model", "chain"}}, {}),
             body = report::html({{"model", "microbody"}}, {});
  BOOST_TEST((has(chain, "acary2003") && !has(chain, "cheng2002")));
  BOOST_TEST((has(body, "cheng2002") && !has(body, "acary2003")));
}

BOOST_AUTO_TEST_CASE(a_run_of_a_chain_leads_with_a_sentence_and_its_balls) {
  const Json result = {{"ending", "separated"},
                       {"model", "chain"},
                       {"final", {{"time", 9.18169681896e-05}, {"velocity", {-0.25, 0.75}}}},
                       {"events", Json::array()},
                       {"energy", {{"initial", 0.016}, {"final", 0.008}, {"work", 0.0}}},
                       {"scene",
                        {{"mass", {0.002, 0.001}},
                         {"radius", {0.01, 0.005}},
                         {"velocity", {1.0, 0.0}},
                         {"gap", {1e-5}},
                         {"contact", Json::array({{{"law", "hertz"}, {"stiffness", 1e9}}})}}}};
  const auto page = report::html(result, {});
  BOOST_TEST(has(page,
                 "The last contact has opened after 91.82 µs. Ball 2 is the fastest then, at 0.75 m/s. "
                 "Of 16 mJ of energy 50 % is kinetic energy in the end."));
  BOOST_TEST(has(
      page,
      "<th>mass [g]</th><th>radius [mm]</th><th>velocity before [m/s]</th><th>velocity after [m/s]</th>"));
  BOOST_TEST(has(page, "<td class=\"n\">1</td><td class=\"n\" title=\"2\">2</td>"));
  BOOST_TEST(has(page, "<th>law</th><th>stiffness k [N/mⁿ]</th><th>gap [µm]</th>"));
}

BOOST_AUTO_TEST_CASE(a_wall_is_no_fastest_ball) {
  const Json result = {{"ending", "separated"},
                       {"model", "chain"},
                       {"final", {{"time", 9e-05}, {"velocity", {-1, -0.5, 0.25}}}},
                       {"events", Json::array()},
                       {"scene",
                        {{"mass", {nullptr, 1.0, 1.0}},
                         {"velocity", {-1.0, 0.0, 0.0}},
                         {"gap", {0.0, 0.0}},
                         {"contact", Json::array({{{"law", "hertz"}, {"stiffness", 1e9}}})}}}};
  BOOST_TEST(has(report::html(result, {}), "Ball 2 is the fastest then, at -0.5 m/s"));
}

BOOST_AUTO_TEST_CASE(all_digits_of_a_number_stand_behind_its_four_in_the_same_unit) {
  const auto page = report::html({{"model", "chain"},
                                  {"final", {{"time", 9.182123456789e-05}}},
                                  {"impulse_direction", {0.123456789, 0.5}}},
                                 {});
  BOOST_TEST(has(page, "<th>time t [µs]</th><td class=\"n\" title=\"91.82123456789\">91.82</td>"), page);
  BOOST_TEST(has(page, "title=\"0.123456789\">0.1235</td>"), page);
}

BOOST_AUTO_TEST_CASE(bodies_with_friction_have_tables_with_units_before_and_after) {
  const Json body = {{"name", "rod"}, {"mass", 0.5}, {"velocity", {1.5, -2.0}}, {"spin", 3.0}};
  const Json contact = {{"between", {"floor", "rod.1"}},
                        {"law", "hertz"},
                        {"tangential", "mindlin"},
                        {"friction", 0.25},
                        {"gap", 0.0}};
  auto idle = contact;
  idle["between"] = {"floor", "rod.2"};
  const Json losses = {{"friction", 2e-5}, {"damper", 0.0}};
  const Json result = {
      {"model", "bodies"},
      {"scene", {{"dimension", 2}, {"body", {body}}, {"contact", {idle, contact}}}},
      {"final", {{"time", 2e-6}, {"bodies", {{{"velocity", {-1.25, 2e-6}}, {"spin", 1e5}, {"angle", 0.5}}}}}},
      {"contacts",
       {{{"between", {"floor", "rod.2"}}, {"peak_force", 0.0}, {"periods", Json::array()}},
        {{"between", {"floor", "rod.1"}},
         {"peak_force", 2e4},
         {"losses", losses},
         {"periods", {{0.0, 1e-6}}}}}}};
  const auto page = report::html(result, {});
  for (const auto* part : {"Before and after", ">velocity x before [m/s]<", ">velocity y after [µm/s]<",
                           ">spin after [krad/s]<", ">floor–rod.1<", ">mindlin<", ">angle φ [rad]<",
                           ">peak force max f<sub>n</sub> [kN]<", ">losses friction [µJ]<",
                           "<td class=\"n\">2</td><td>floor–rod.1</td>", "1 other pair has never closed."})
    BOOST_TEST(has(page, part), part);
  BOOST_TEST(!has(page, "{&quot;"));
  BOOST_TEST(!has(page, "rod.2"));  // numbers of contacts are those of the result
}

BOOST_AUTO_TEST_CASE(bodies_in_space_have_three_components) {
  const Json body = {{"name", "ball"}, {"mass", 0.5}, {"velocity", {1, 2, 3}}, {"spin", {4, 5, 6}}};
  const Json result = {{"model", "bodies"},
                       {"scene", {{"dimension", 3}, {"body", {body}}, {"contact", Json::array()}}},
                       {"final", {{"time", 1}, {"bodies", {body}}}}};
  const auto page = report::html(result, {});
  BOOST_TEST(has(page, ">velocity z after [m/s]<"));
  BOOST_TEST(has(page, ">spin z before [rad/s]<"));
}

BOOST_AUTO_TEST_CASE(a_sweep_leads_with_a_sentence) {
  Json result = {
      {"points", 12},
      {"failed", 0},
      {"varied", {{{"key", "chain.mass[0]"}, {"axis", 0}}, {{"key", "chain.gap[1]"}, {"axis", 1}}}},
      {"columns",
       {{{"key", "chain.mass[0]"}, {"least", 1}, {"greatest", 2}},
        {{"key", "icr[0]"}, {"least", 0.75}, {"greatest", 1.5}}}}};
  BOOST_TEST(
      has(report::html(result, {}),
          "<p class=\"lead\">12 points vary chain.mass[0] and chain.gap[1]. All have a result. icr[0] lies "
          "between 0.75 and 1.5.</p>"));
  result["failed"] = 3;
  result["columns"][1]["least"] = nullptr;
  BOOST_TEST(has(report::html(result, {}), "chain.gap[1]. 3 without a result.</p>"));
}

BOOST_AUTO_TEST_CASE(headings_and_cards_are_words_and_short_numbers) {
  const auto page = report::html({{"title", "t"},
                                  {"shared_friction", true},
                                  {"accuracy", {{"requested", 1e-10}, {"estimated", 7.800274e-13}}}},
                                 {});
  BOOST_TEST(!has(page, ">shared_friction<"));
  BOOST_TEST(has(page, "Two tips stuck at once and shared the least friction</h2>\n<p>yes</p>"));
  BOOST_TEST(!has(report::html({{"shared_friction", false}}, {}), "stuck at once"));
  BOOST_TEST(has(page, "accuracy estimated<b>7.8e-13</b>"));
}

BOOST_AUTO_TEST_CASE(walls_and_planes_have_names_instead_of_infinite_numbers) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const Json& beyond : {Json(nullptr), Json(infinite)}) {
    const Json result = {{"ending", "separated"},
                         {"model", "chain"},
                         {"final", {{"velocity", {0.0, 0.2}}}},
                         {"bound_frequency", Json::array()},
                         {"scene",
                          {{"mass", {beyond, 0.002}},
                           {"radius", {beyond, 0.1}},
                           {"velocity", {0.0, -0.2}},
                           {"contact", Json::array()}}}};
    const auto page = report::html(result, {});
    BOOST_TEST(has(page, "<td>wall</td><td>plane</td>"));
    BOOST_TEST(!has(page, "inf<"));
    BOOST_TEST(!has(page, "bound_frequency"));  // nothing rings on
  }
}

BOOST_AUTO_TEST_CASE(columns_have_symbols_and_units_and_are_left_out_if_empty) {
  const Json contacts = Json::array({{{"impulse", 0.0349907588842897},
                                      {"peak_force", 1007.04},
                                      {"periods", Json::array({Json::array({0.0, 6.9e-5})})}}});
  const auto table = report::table(contacts, {"chain", "contacts"});
  BOOST_TEST(has(
      table,
      "<th>impulse p<sub>j</sub> [mN s]</th><th>peak force max f<sub>j</sub> [N]</th><th>periods [µs]</th>"));
  BOOST_TEST(has(table, ">34.99</td>"));
  BOOST_TEST(has(table, "[0, 69]"));
  const Json events = Json::array({{{"time", 0.0}, {"open", {1}}, {"stick", Json::array()}}});
  BOOST_TEST(!has(report::table(events, {"chain", "events"}), "stick"));
}

BOOST_AUTO_TEST_CASE(columns_of_zeros_are_named_below) {
  const auto contact = [](double impulse) {
    return Json{{"impulse", impulse}, {"stored", 0.0}, {"plastic_work", -0.0}, {"peak_force", impulse}};
  };
  const auto table = report::table(Json::array({contact(0), contact(2)}), {"chain", "contacts"});
  BOOST_TEST(count(table, "<th>") == 3);
  BOOST_TEST(has(table, "<p>Zero in every line: stored, plastic work.</p>"));
  BOOST_TEST(has(table, ">0</td>"));
  const Json start = Json::array({{{"time", 0.0}, {"close", {1}}}});
  BOOST_TEST(!has(report::table(start, {"chain", "events"}), "Zero"));
  BOOST_TEST(has(report::table(Json::array({-0.0, 1.0}), {}), ">0</td>"));
}

BOOST_AUTO_TEST_CASE(a_long_table_is_cut_in_the_middle) {
  Json list = Json::array();
  for (int i = 0; i < 1000; ++i) list.push_back(i);
  const auto table = report::table(list);
  BOOST_TEST(count(table, "<tr>") == 61);
  BOOST_TEST(has(table, "… 940 more …"));
  BOOST_TEST(has(table, ">999<"));
}

BOOST_AUTO_TEST_CASE(the_command_repeats_the_run) {
  const Json result = {{"provenance", {{"scene", "it's.toml"}, {"overrides", {"chain.velocity[0]=2 m/s"}}}}};
  BOOST_TEST(report::repeating_command(result) ==
             "mariotte run 'it'\\''s.toml' --set 'chain.velocity[0]=2 m/s'");
  BOOST_TEST(report::repeating_command(Json::object()) == "");
  const Json of_python = {{"provenance", {{"scene", "<Chain>"}, {"run", {{"accuracy", 1e-6}}}}}};
  BOOST_TEST(report::repeating_command(of_python) == "");
}
