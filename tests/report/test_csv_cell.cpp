#define BOOST_TEST_MODULE report_csv_cell
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "mariotte/report/csv/csv_cell.hpp"

using namespace mariotte;
using Cells = std::vector<std::string>;

namespace {

Cells cells_of(const std::string& line) {
  Cells cells = {"what", "was", "there", "before"};
  report::split(line, cells);
  return cells;
}

}  // namespace

BOOST_AUTO_TEST_CASE(cells_lie_between_commas) {
  const auto same = boost::test_tools::per_element();
  BOOST_TEST(cells_of("1,0.5,separated,") == (Cells{"1", "0.5", "separated", ""}), same);
  BOOST_TEST(cells_of(",,") == (Cells{"", "", ""}), same);
  BOOST_TEST(cells_of("one") == Cells{"one"}, same);
  BOOST_TEST(cells_of("") == Cells{""}, same);
  BOOST_TEST(cells_of(R"("a, ""b""",c)") == (Cells{"a, \"b\"", "c"}), same);
}

BOOST_AUTO_TEST_CASE(a_cell_is_a_number_as_a_whole_or_not_at_all) {
  BOOST_TEST(report::number("-0.5e-3") == -0.5e-3);
  BOOST_TEST(std::isinf(report::number("inf")));
  for (const auto* text : {"", "2x", " 2", "two", "1e999"})
    BOOST_TEST(std::isnan(report::number(text)), text);
}

BOOST_AUTO_TEST_CASE(what_is_written_is_read_back) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> length(0, 6);
  const std::string letters = "a,\" ;µ";
  for (int trial = 0; trial < 10000; ++trial) {
    Cells cells(length(random) + 1);
    std::string line;
    for (auto& text : cells) {
      for (auto i = length(random); i > 0; --i) text += letters[random() % letters.size()];
      line += (&text == cells.data() ? "" : ",") + report::cell(text);
    }
    BOOST_REQUIRE((cells_of(line) == cells));
  }
}
