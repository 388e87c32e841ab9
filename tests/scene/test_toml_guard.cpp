#define BOOST_TEST_MODULE scene_toml_guard
#include <boost/test/unit_test.hpp>
#include <string>

#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/toml.hpp"
#include "mariotte/scene/toml_guard.hpp"

namespace {

using namespace mariotte::scene;

const Source source{.name = "f", .origins = {}};

std::string verdict(const std::string& text) {
  try {
    guard_toml(source, text);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "passed";
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_that_a_scene_needs_passes) {
  for (const auto* text :
       {"", "\n", "a = 1\r\nb = 2\r\n",
        "\xef\xbb\xbf"
        "a = 1",
        "# any character in a comment: \u00b5 \ufe7f (", "title = \"\u00b5m and \U0001f600 (in strings)\"",
        "a = 'C:\\'\nb = 1", "a = \"say \\\"hi\\\" # no comment\"", "a = \"\"\nb = ''",
        "a = \"\"\"\nx\n\"\"\"\"\"", "a = '''it's'''", "[[chain.ball]]\nx = [{ a = [1, 2.5e-3] }]",
        "a = { b = 1, c = 2 }\nd = [\n  { e = 1 },\n  { e = 2, f = '=' },\n]\ng = 3",
        "a = [1,-2\n,3 ,\t4#\n]", "a = { b = true }\n[c.d]\ne = [[1], []]\n1979-05-9- = 1",
        "a = \"\"\"x \\\n   y\"\"\"", "a.b . c = +1_000"})
    BOOST_TEST(verdict(text) == "passed", text);
}

BOOST_AUTO_TEST_CASE(what_trips_the_parser_is_rejected_where_it_stands) {
  BOOST_TEST(verdict("[(") == "f:1:2: unexpected '('");
  BOOST_TEST(verdict("\xef\xb9\xbf") == "f:1:1: unexpected '\ufe7f'");
  BOOST_TEST(verdict("a = 1\n\u00b5 = 2") == "f:2:1: unexpected '\u00b5'");
  BOOST_TEST(verdict("a = ['\u00b5'{'\u00b7'") == "f:1:9: unexpected bracket");
  BOOST_TEST(verdict("a = ['\u00b5''\u00b7'") == "f:1:9: unexpected quote");
  BOOST_TEST(verdict("a = '0'='\u00b7'") == "f:1:8: unexpected '='");
  BOOST_TEST(verdict("a = \"\"\"\\\n \u00b5\"\"\"") == "f:2:2: only ASCII characters may follow a backslash");
}

BOOST_AUTO_TEST_CASE(values_without_quotes_are_whole) {
  for (const auto* text :
       {"a = 1'\u00b5'", "a = 1{'\u00b7'", "a = 0=='\u00b7'", "a = 1 2", "a = [1 2]", "a = 1 b = 2"})
    BOOST_TEST(verdict(text).ends_with("a number with a unit stands between quotes"), text);
  BOOST_TEST(verdict("a = [1,2  [").starts_with("f:1:11:"));
  for (const auto* word :
       {"1979-05-27", "1979-06-68", "1979-05-9-", "07:32:00", "hertz", "22e30A8", "1t", "2..", "-"})
    for (const auto* rest : {"", " 1#21", "['\u00b7'", "\n", "='\u00b7'"})
      for (const auto* start : {"a = ", "a = [0, ", "a = {b ="})
        BOOST_TEST(verdict(std::string(start) + word + rest) ==
                       "f:1:" + std::to_string(std::string(start).size() + 1) + ": \"" + word +
                           "\" is no number, and text stands between quotes",
                   start << word << rest);
}

BOOST_AUTO_TEST_CASE(points_of_numbers_have_digits_on_both_sides) {
  for (const auto* word : {".5", "5.", "-.5", "1.e3"})
    BOOST_TEST(verdict(std::string("a = ") + word) ==
               std::string("f:1:5: \"") + word + "\" is no number: digits stand on both sides of the point");
}

BOOST_AUTO_TEST_CASE(columns_count_characters_not_bytes) {
  BOOST_TEST(verdict("a = \"\u00b5\u00b5\u00b5\" (") == "f:1:11: unexpected '('");
}

BOOST_AUTO_TEST_CASE(text_must_be_utf8) {
  for (const auto* bytes : {"\x80", "\xff", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80",
                            "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82"}) {
    BOOST_TEST(verdict("#" + std::string(bytes)) == "f:1:2: not valid UTF-8");
    BOOST_TEST(verdict("a = '" + std::string(bytes) + "'") == "f:1:6: not valid UTF-8");
  }
}

BOOST_AUTO_TEST_CASE(control_characters_are_rejected_everywhere) {
  for (const char c : {'\0', '\x01', '\x1b', '\x7f', '\r'}) {
    BOOST_TEST(verdict("a = '" + std::string(1, c) + "'") == "f:1:6: control characters are not allowed");
    BOOST_TEST(verdict("#" + std::string(1, c)) == "f:1:2: control characters are not allowed");
  }
}

BOOST_AUTO_TEST_CASE(strings_must_end) {
  BOOST_TEST(verdict("a = \"x\nb = 1") == "f:1:5: the string does not end");
  BOOST_TEST(verdict("a = 'x") == "f:1:5: the string does not end");
  BOOST_TEST(verdict("\na = '''x''\n") == "f:2:5: the string does not end");
  BOOST_TEST(verdict("a = \"x\\\"") == "f:1:5: the string does not end");
}

BOOST_AUTO_TEST_CASE(nesting_is_limited) {
  BOOST_TEST(verdict("a = " + std::string(16, '[') + std::string(16, ']')) == "passed");
  BOOST_TEST(verdict("a = " + std::string(17, '[')) == "f:1:21: nested too deeply");
  BOOST_TEST(verdict("a = " + std::string(1000000, '{')) == "f:1:21: nested too deeply");
}

BOOST_AUTO_TEST_CASE(dotted_keys_are_limited) {
  std::string key = "a";
  for (int i = 1; i < 16; ++i) key += ".a";
  BOOST_TEST(verdict(key + " = 1") == "passed");
  BOOST_TEST(verdict(key + ".a = 1") == "f:1:32: too many dots in one key");
}

BOOST_AUTO_TEST_CASE(keys_and_values_remember_their_place) {
  const auto tree = parse_toml(source, "\n[chain]\nmass = [1, \"\u00b5\", 3]\n");
  const auto* chain = find(*tree.table(), "chain");
  const auto* mass = find(*chain->node.table(), "mass");
  BOOST_TEST(mass->place.line == 3);
  BOOST_TEST(mass->place.column == 1);
  BOOST_TEST((*mass->node.array())[2].place.column == 17);
}
