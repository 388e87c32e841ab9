// Keys of balls and contacts, and their places in results.
#define BOOST_TEST_MODULE scene_result_key
#include <boost/test/unit_test.hpp>

#include "mariotte/scene/result_key.hpp"

using namespace mariotte;

namespace {

std::string placed(const std::string& text, const std::string& key) {
  return scene::key_in_results(scene::parse_document(text, "scene.toml"), key);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_table_with_a_number_is_that_of_this_ball_or_contact) {
  const auto* text =
      "[chain]\nballs = 5\n[[chain.ball]]\nnumber = 5\nvelocity = 1\n[[chain.contact]]\nnumber = 3\n";
  BOOST_TEST(placed(text, "chain.ball[0].velocity") == "chain.ball[4].velocity");
  BOOST_TEST(placed(text, "chain.contact[0].stiffness") == "chain.contact[2].stiffness");
  BOOST_TEST(placed(text, "chain.contact[7].stiffness") == "chain.contact[7].stiffness");
}

BOOST_AUTO_TEST_CASE(a_wall_on_the_left_is_the_first_ball) {
  for (const char* wall : {"left", "both"}) {
    const auto text = "[chain]\nwall = '" + std::string(wall) + "'\n";
    BOOST_TEST(placed(text, "chain.velocity[0]") == "chain.velocity[1]");
    BOOST_TEST(placed(text, "chain.material[1].young") == "chain.material[2].young");
    BOOST_TEST(placed(text, "chain.gap[1]") == "chain.gap[1]");
  }
  BOOST_TEST(placed("[chain]\nwall = 'right'\n", "chain.velocity[0]") == "chain.velocity[0]");
}

BOOST_AUTO_TEST_CASE(any_other_key_stays) {
  for (const char* key : {"mass[0]", "chain.material.young", "contact[1].stiffness", "run.accuracy", "",
                          "incidence.angles[1]", "chain.velocity["})
    BOOST_TEST(placed("[chain]\nwall = 'left'\n", key) == key);
}
