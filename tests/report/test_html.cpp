#define BOOST_TEST_MODULE report_html
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "mariotte/report/page/html.hpp"
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
  BOOST_TEST(!has(page, "<script"));
  BOOST_TEST(has(page, "alt=\"x&quot;y\""));
}

BOOST_AUTO_TEST_CASE(the_page_needs_no_other_file) {
  const auto page = report::html({{"title", "t"}}, {{"forces", "<svg></svg>"}});
  BOOST_TEST(has(page, "src=\"data:image/svg+xml;base64,PHN2Zz48L3N2Zz4=\""));
  for (const auto* part : {"http:", "https:", "src=\"/", "url(", "@import", "<script"})
    BOOST_TEST(!has(page, part), part);
}

BOOST_AUTO_TEST_CASE(every_part_of_a_result_is_on_the_page) {
  const Json result = {{"ending", "captured"},
                       {"title", "A body"},
                       {"final", {{"time", 0.5}, {"quaternion", {1.0, 0.0, 0.0, 0.0}}}},
                       {"impacts", {{{"tip", 1}, {"start", 0.125}}, {{"tip", 2}, {"start", 0.25}}}},
                       {"restitution", {{"tip", 0.625}, {"centre", nullptr}}},
                       {"energy", {{"initial", 2.0}, {"residual", -4e-10}}},
                       {"something_new", {1, 2, 3}},
                       {"provenance", {{"version", "1.2.3"}, {"scene_sha256", "abc"}}}};
  const auto page = report::html(result, {});
  for (const auto* part : {"captured", "0.125", "0.25", "0.625", "2.0e-10 of it", "something_new",
                           "version = {1.2.3}", "note    = {scene abc}", "@inproceedings"})
    BOOST_TEST(has(page, part), part);
  BOOST_TEST(count(page, "<table>") == count(page, "</table>"));
  BOOST_TEST(count(page, "<tr>") == count(page, "</tr>"));
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
}
