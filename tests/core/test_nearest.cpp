#define BOOST_TEST_MODULE core_nearest
#include <array>
#include <boost/test/unit_test.hpp>
#include <string>

#include "mariotte/core/nearest.hpp"

namespace {

using mariotte::nearest;

constexpr std::array<std::string_view, 5> keys{"stiffness", "damping", "exponent", "gap", "MPa"};

}  // namespace

BOOST_AUTO_TEST_CASE(one_slip_of_each_kind_is_forgiven) {
  BOOST_TEST(nearest("stiffnes", keys) == "stiffness");
  BOOST_TEST(nearest("stifffness", keys) == "stiffness");
  BOOST_TEST(nearest("damqing", keys) == "damping");
  BOOST_TEST(nearest("exopnent", keys) == "exponent");
  BOOST_TEST(nearest("Gap", keys) == "gap");
}

BOOST_AUTO_TEST_CASE(a_changed_case_is_nearer_than_a_changed_letter) {
  constexpr std::array<std::string_view, 2> units{"kPa", "MPa"};
  BOOST_TEST(nearest("mPa", units) == "MPa");
}

BOOST_AUTO_TEST_CASE(a_word_unlike_all_others_has_no_neighbour) {
  BOOST_TEST(nearest("colour", keys).empty());
  BOOST_TEST(nearest("xyz", keys).empty());
  BOOST_TEST(nearest("", keys).empty());
  BOOST_TEST(nearest(std::string(100000, 's'), keys).empty());
}

BOOST_AUTO_TEST_CASE(the_nearest_few_hold_the_word_first) {
  constexpr std::array<std::string_view, 4> names{"triplet", "y_chain", "bernoulli", "tapered_chain"};
  const auto few = mariotte::nearest_few("chain", names, 3);
  BOOST_TEST(few == (std::vector<std::string_view>{"y_chain", "tapered_chain", "triplet"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_suggestion_is_ready_to_append) {
  BOOST_TEST(mariotte::suggestion("gpa", keys) == " (did you mean 'gap'?)");
  BOOST_TEST(mariotte::suggestion("colour", keys).empty());
  BOOST_TEST(mariotte::suggestion_or_few("gpa", keys) == " (did you mean 'gap'?)");
  BOOST_TEST(mariotte::suggestion_or_few("colour", keys).starts_with(" (nearest: "));
  BOOST_TEST(mariotte::suggestion_or_few("colour", {}).empty());
}

BOOST_AUTO_TEST_CASE(a_path_that_ends_like_the_word_is_nearer_than_a_misspelling) {
  constexpr std::array<std::string_view, 3> paths{"radii", "chain.radius", "chain.material"};
  BOOST_TEST(mariotte::suggested_path("radius", paths) == " (did you mean 'chain.radius'?)");
  BOOST_TEST(mariotte::suggested_path("chain.radus", paths) == " (did you mean 'chain.radius'?)");
  BOOST_TEST(mariotte::suggested_path("colour", paths).empty());
}
