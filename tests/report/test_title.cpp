#define BOOST_TEST_MODULE report_title
#include <boost/test/unit_test.hpp>

#include "mariotte/report/figure/title.hpp"

using mariotte::report::wrapped;

BOOST_AUTO_TEST_CASE(a_short_title_is_one_line) {
  BOOST_TEST(wrapped("It's short").text == "'It''s short'");
  BOOST_TEST(wrapped("It's short").more_height == 0);
  BOOST_TEST(wrapped("").text == "''");
}

BOOST_AUTO_TEST_CASE(a_long_title_breaks_at_blanks) {
  const auto made = wrapped("one two three four", 9);
  BOOST_TEST(made.text == R"('one two'."\n".'three'."\n".'four')");
  BOOST_TEST(made.more_height == 2 * wrapped("three four", 9).more_height);
  BOOST_TEST(wrapped("unbreakable words", 3).text == R"('unbreakable'."\n".'words')");
}

BOOST_AUTO_TEST_CASE(letters_are_counted_and_not_their_bytes) {
  BOOST_TEST(wrapped("Stöße über Öl", 13).text == "'Stöße über Öl'");
}

BOOST_AUTO_TEST_CASE(of_a_very_long_title_the_rest_is_left_out) {
  BOOST_TEST(wrapped("a b c d e", 1).text == R"('a'."\n".'b'."\n".'c …')");
}
