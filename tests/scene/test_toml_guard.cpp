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
        "a = 1979-05-27T07:32:00Z", "a = \"\"\"x \\\n   y\"\"\"", "a.b . c = +1_000"})
    BOOST_TEST(verdict(text) == "passed", text);
}

BOOST_AUTO_TEST_CASE(what_trips_the_parser_is_rejected_where_it_stands) {
  BOOST_TEST(verdict("[(") == "f:1:2: unexpected '('");
  BOOST_TEST(verdict("\xef\xb9\xbf") == "f:1:1: unexpected '\ufe7f'");
  BOOST_TEST(verdict("a = 1\n\u00b5 = 2") == "f:2:1: unexpected '\u00b5'");
  BOOST_TEST(verdict("a = 1'\u00b5'") == "f:1:6: unexpected quote");
  BOOST_TEST(verdict("a = 22e30A8['\u00b7'") == "f:1:12: unexpected bracket");
  BOOST_TEST(verdict("a = 0=='\u00b7'") == "f:1:6: unexpected '='");
  BOOST_TEST(verdict("a = [1t='\u00b7'") == "f:1:8: unexpected '='");
  BOOST_TEST(verdict("a = [1979-06-68 1,\"=[\u00b7\"]") ==
             "f:1:17: unexpected digit after a number and a blank");
  BOOST_TEST(verdict("a = 1{'\u00b7'") == "f:1:6: unexpected bracket");
  BOOST_TEST(verdict("a = \"\"\"\\\n \u00b5\"\"\"") == "f:2:2: only ASCII characters may follow a backslash");
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
