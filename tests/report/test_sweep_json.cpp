#define BOOST_TEST_MODULE report_sweep_json
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mariotte/report/json/sweep_json.hpp"

using namespace mariotte;
using report::Json;

namespace {

study::SweepPlan plan() {
  const scene::Node soft{.value = std::string("soft"), .place = {}}, two{.value = 2.0, .place = {}};
  study::SweepPlan plan;
  plan.title = "A sweep";
  plan.design.parameters = {
      {.key = "a", .axis = 0, .range = study::Range{.from = 1, .to = 9}},
      {.key = "b", .axis = 0, .list = {soft, two}},
      {.key = "c", .axis = 1, .range = study::Range{.to = 1, .logarithmic = true, .seed = 7}}};
  plan.design.axes = {{.count = 2, .stride = 3}, {.count = 3, .stride = 1}};
  plan.columns = {{"icr[0]"}};
  return plan;
}

Json summary(const std::string& csv) {
  std::istringstream stream(csv);
  return report::summary(stream);
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_varied_is_told_as_it_was_asked_for) {
  const auto all = report::json(plan(), 1);
  BOOST_TEST(all["points"] == 6);
  BOOST_TEST(all["failed"] == 1);
  const Json varied = {
      {{"key", "a"}, {"axis", 0}, {"count", 2}, {"from", 1.0}, {"to", 9.0}, {"scale", "linear"}},
      {{"key", "b"}, {"axis", 0}, {"count", 2}, {"values", {"soft", 2.0}}},
      {{"key", "c"},
       {"axis", 1},
       {"count", 3},
       {"from", 0.0},
       {"to", 1.0},
       {"scale", "log"},
       {"random", 7},
       {"design", "random"}}};
  BOOST_TEST(all["varied"] == varied);
  BOOST_TEST(all["provenance"]["columns"] == Json({"icr[0]"}));
}

BOOST_AUTO_TEST_CASE(a_summary_counts_rows_and_spans_numbers) {
  const auto all = summary(
      "law,icr[0],ending,reason\n"
      "soft,2,separated,\n"
      "soft,,separated,\n"
      "hard,,failed,\"stuck, at 2\"\n"
      "hard,-0.5,max_time,\n"
      "odd,,rejected,no mass\n"
      "odd,,failed,\"stuck, at 2\"\n");
  BOOST_TEST(all["columns"].size() == 2);
  for (const auto& [key, law, ratio] : {std::tuple<const char*, Json, Json>("key", "law", "icr[0]"),
                                        {"numbers", 0, 2},
                                        {"least", nullptr, -0.5},
                                        {"greatest", nullptr, 2.0},
                                        {"mean", nullptr, 0.75}}) {
    BOOST_TEST(all["columns"][0][key] == law, key);
    BOOST_TEST(all["columns"][1][key] == ratio, key);
  }
  BOOST_TEST(all["endings"] == Json({{{"ending", "failed"}, {"points", 2}, {"first_row", 3}},
                                     {{"ending", "separated"}, {"points", 2}, {"first_row", 1}},
                                     {{"ending", "max_time"}, {"points", 1}, {"first_row", 4}},
                                     {{"ending", "rejected"}, {"points", 1}, {"first_row", 5}}}));
  BOOST_TEST(all["reasons"] == Json({{{"reason", "stuck, at 2"}, {"points", 2}, {"first_row", 3}},
                                     {{"reason", "no mass"}, {"points", 1}, {"first_row", 5}}}));
}

BOOST_AUTO_TEST_CASE(a_file_without_rows_has_nothing_to_tell) {
  const auto all = summary("");
  for (const auto* part : {"columns", "endings", "reasons"}) BOOST_TEST(all[part].empty(), part);
}
