#define BOOST_TEST_MODULE report_sweep_rows
#include <boost/test/unit_test.hpp>
#include <limits>

#include "mariotte/report/csv/sweep_csv.hpp"
#include "mariotte/report/csv/sweep_rows.hpp"

using namespace mariotte;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A number and a word with a comma vary: 3 × 2 points.
study::Design design() {
  const scene::Node soft{.value = std::string("soft"), .place = {}},
      hard{.value = std::string("hä, rd"), .place = {}};
  return {.parameters = {{.key = "chain.mass[1]", .axis = 0, .range = study::Range{.from = 1, .to = 3}},
                         {.key = "law", .axis = 1, .list = {soft, hard}}},
          .axes = {{.count = 3, .stride = 2}, {.count = 2, .stride = 1}}};
}

/// Points 2 to 4 as a sweep writes them; the last has no numbers.
study::Rows written() {
  study::Batch batch;
  batch.first = 2;
  batch.numbers = {1.5, -1e-300, 0.1, infinity, none, none};
  batch.verdicts = {{.ending = "separated"},
                    {.ending = "time_limit"},
                    {.ending = "rejected", .reason = "no, \"it\" is not"}};
  study::Rows rows{.first = 2, .count = 3, .failed = 1};
  report::append_rows(design(), batch, rows.text);
  return rows;
}

bool believed(const study::Rows& rows) {
  return report::are_rows_of(design(), 2, rows);
}

study::Rows with(const std::string& part, const std::string& instead) {
  auto rows = written();
  const auto at = rows.text.find(part);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  rows.text.replace(at, part.size(), instead);
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_a_sweep_writes_is_believed) {
  BOOST_TEST(believed(written()), written().text);
  BOOST_TEST(believed(with("1.5,", ",")));  // a quantity that this impact has not
  for (const char* ending : {"captured", "bound", "event_limit", "interrupted"})
    BOOST_TEST(believed(with("separated", ending)), ending);
  BOOST_TEST(believed(with("separated,", "separated,what is to say of slopes")));
}

BOOST_AUTO_TEST_CASE(other_cells_are_not) {
  for (const char* cell : {"nonsense", "nan", "1.5x", " 1.5", "1.5,2", "\"1.5"})
    BOOST_TEST(!believed(with("1.5", cell)), cell);
  BOOST_TEST(!believed(with("separated", "departed")));
  BOOST_TEST(!believed(with("time_limit", "failed")));   // with numbers
  BOOST_TEST(!believed(with("rejected", "separated")));  // one without numbers less
  BOOST_TEST(!believed(with("2,soft", "2.5,soft")));     // another point
  BOOST_TEST(!believed(with("soft", "hard")));
}

BOOST_AUTO_TEST_CASE(neither_are_other_numbers_of_rows) {
  for (auto change : {&study::Rows::first, &study::Rows::count, &study::Rows::failed})
    for (const Index by : {-1, 1}) {
      auto rows = written();
      rows.*change += by;
      BOOST_TEST(!believed(rows));
    }
  auto rows = written();
  rows.text.pop_back();
  BOOST_TEST(!believed(rows));
}
