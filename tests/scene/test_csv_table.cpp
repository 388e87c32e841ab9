#define BOOST_TEST_MODULE scene_csv_table
#include <boost/test/unit_test.hpp>

#include "mariotte/scene/csv_table.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte::scene;

namespace {

const Source source{.name = "data.csv", .origins = {}};

std::string rejection(const std::string& text) {
  try {
    parse_csv(source, text);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(cells_know_where_they_were_written) {
  const auto table = parse_csv(source, "a, b\n\n  1 ,2\n");
  BOOST_TEST_REQUIRE(table.header.size() == 2u);
  BOOST_TEST_REQUIRE(table.rows.size() == 1u);
  BOOST_TEST(table.header[1].text == "b");
  BOOST_TEST(table.header[1].place.column == 4);
  BOOST_TEST(table.rows[0][0].text == "1");
  BOOST_TEST(table.rows[0][0].place.line == 3);
  BOOST_TEST(table.rows[0][0].place.column == 3);
}

BOOST_AUTO_TEST_CASE(comments_blank_lines_and_other_ends_of_lines_change_nothing) {
  const auto plain = parse_csv(source, "a,b\n1,2\n3,4");
  const auto other = parse_csv(source, "\xef\xbb\xbf# who, when\r\na,b\r\n\r\n1,2\r\n  # a pause\r\n3,4\r\n");
  BOOST_TEST_REQUIRE(other.rows.size() == plain.rows.size());
  for (std::size_t row = 0; row < plain.rows.size(); ++row)
    for (std::size_t i = 0; i < 2; ++i) BOOST_TEST(other.rows[row][i].text == plain.rows[row][i].text);
}

BOOST_AUTO_TEST_CASE(quoted_cells_may_hold_commas_and_quotes) {
  const auto table = parse_csv(source, "\"speed\" , \"a, \"\"b\"\"\"\n\"\",2\n");
  BOOST_TEST(table.header[0].text == "speed");
  BOOST_TEST(table.header[1].text == "a, \"b\"");
  BOOST_TEST(table.rows[0][0].text == "");
}

BOOST_AUTO_TEST_CASE(a_cell_may_be_empty_anywhere) {
  const auto table = parse_csv(source, "a,b,c\n,,\n");
  BOOST_TEST_REQUIRE(table.rows[0].size() == 3u);
  for (const auto& cell : table.rows[0]) BOOST_TEST(cell.text == "");
}

BOOST_AUTO_TEST_CASE(what_is_no_table_is_refused_at_its_place) {
  BOOST_TEST(rejection("") == "data.csv:1:1: the table is empty");
  BOOST_TEST(rejection("# nothing\n\n") == "data.csv:1:1: the table is empty");
  BOOST_TEST(rejection("a,b\n1\n") == "data.csv:2:1: the row has 1 cells, the header 2");
  BOOST_TEST(rejection("a,b\n1,2,3\n") == "data.csv:2:1: the row has 3 cells, the header 2");
  BOOST_TEST(rejection("a,\"b\n1,2\n") == "data.csv:1:3: the quote has no end on its line");
  BOOST_TEST(rejection("a,\"b\" c\n") == "data.csv:1:7: expected a comma after the quote");
}
