#define BOOST_TEST_MODULE scene_toml_value
#include <boost/test/unit_test.hpp>
#include <random>
#include <string>

#include "mariotte/scene/toml.hpp"
#include "mariotte/scene/toml_value.hpp"

using namespace mariotte::scene;

BOOST_AUTO_TEST_CASE(numbers_of_toml_are_values) {
  for (const auto* word : {"0",    "-0",          "+1",    "42",      "1_000",       "1_2_3", "0.5",
                           "-0.0", "+6.626e-34",  "5e+22", "1E06",    "1_0.0_1e1_0", "inf",   "-inf",
                           "+nan", "0xDEAD_beef", "0o755", "0b11_01", "true",        "false"})
    BOOST_TEST(is_plain_value(word), word);
}

BOOST_AUTO_TEST_CASE(what_is_not_quite_a_number_is_none) {
  for (const auto* word :
       {"",         "+",    "-",    "01",    "00.5", "-01",        ".5",       "5.",
        "1._5",     "1__0", "_1",   "1_",    "1e",   "1e+",        "1.e2",     "e2",
        "0x",       "0xg",  "0x_1", "+0x1",  "0o8",  "0b2",        "0X1",      "Inf",
        "infinity", "+-1",  "True", "1.2.3", "1,5",  "1979-05-27", "07:32:00", "1979-05-27T07:32:00Z"})
    BOOST_TEST(!is_plain_value(word), word);
}

BOOST_AUTO_TEST_CASE(the_parser_takes_every_value) {
  std::mt19937 random(1);
  const std::string letters = "00111__..ee+-xobaf";
  int values = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    std::string word;
    for (auto size = 1 + random() % 5; size > 0; --size) word += letters[random() % letters.size()];
    if (!is_plain_value(word)) continue;
    ++values;
    BOOST_TEST_REQUIRE(parse_toml({}, "a = " + word).table()->size() == 1, word);
  }
  BOOST_TEST(values > 5000);
}
