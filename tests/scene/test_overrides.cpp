#define BOOST_TEST_MODULE scene_overrides
#include <boost/test/unit_test.hpp>
#include <string>

#include "mariotte/scene/scene.hpp"

namespace {

using namespace mariotte;

const std::string text = R"([chain]
mass = [1, 1, 1]
velocity = [1, 0, 0]
[[chain.contact]]
law = "hertz"
stiffness = 1
[[chain.contact]]
law = "hertz"
stiffness = 2
)";

const model::Chain& chain(const scene::Scene& scene) {
  return std::get<model::Chain>(scene.model);
}

scene::Scene with(const scene::Overrides& overrides) {
  return scene::parse(text, "f", overrides);
}

std::string complaint(const std::string& override) {
  try {
    with({override});
  } catch (const scene::SceneError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_override_replaces_one_value) {
  BOOST_TEST(chain(with({"chain.velocity[0]=2"})).velocity[0] == 2);
  BOOST_TEST(contact::stiffness(chain(with({"chain.contact[1].stiffness=4"})).law[1]) == 4);
  BOOST_TEST(contact::stiffness(chain(with({"chain.contact[1].stiffness=4"})).law[0]) == 1);
}

BOOST_AUTO_TEST_CASE(a_value_with_a_unit_needs_no_quotes) {
  BOOST_TEST(chain(with({"chain.velocity[0]=2 mm/s"})).velocity[0] == 2e-3);
  BOOST_TEST(chain(with({"chain.velocity[0]=\"2 mm/s\""})).velocity[0] == 2e-3);
  BOOST_TEST(chain(with({" chain.velocity[0] = 2 mm/s "})).velocity[0] == 2e-3);
}

BOOST_AUTO_TEST_CASE(a_value_may_be_an_array_or_a_table) {
  const auto scene = with({"chain.mass=[inf, 2, 3 ]", "chain.contact[0]={ law = 'linear', stiffness = 5 }"});
  BOOST_TEST(chain(scene).mass[1] == 2);
  BOOST_TEST(contact::exponent(chain(scene).law[0]) == 1);
}

BOOST_AUTO_TEST_CASE(a_missing_key_or_table_is_created) {
  BOOST_TEST(with({"run.accuracy=1e-8"}).run.accuracy == 1e-8);
  BOOST_TEST(with({"title=five balls"}).title == "five balls");
}

BOOST_AUTO_TEST_CASE(the_last_of_two_overrides_wins) {
  BOOST_TEST(with({"run.accuracy=1e-8", "run.accuracy=1e-6"}).run.accuracy == 1e-6);
}

BOOST_AUTO_TEST_CASE(an_override_may_not_smuggle_in_more_than_one_value) {
  BOOST_TEST(with({"title=1\nchain = 2"}).title == "1\nchain = 2");
}

BOOST_AUTO_TEST_CASE(a_path_that_leads_nowhere_is_named) {
  BOOST_TEST(complaint("chain.velocity[9]=2") ==
             "--set chain.velocity[9]: no element 9: 'chain.velocity' has 3 (counted from 0)");
  BOOST_TEST(
      complaint("chain.gap[0]=2") ==
      "--set chain.gap[0]: the scene has no 'chain.gap' (one gap for all, or none, has no elements; a list, "
      "gap = [...], has)");
  BOOST_TEST(complaint("chain.velocitty[0]=2") ==
             "--set chain.velocitty[0]: the scene has no 'chain.velocitty' (did you mean 'velocity'?)");
  BOOST_TEST(
      complaint("network.stiffness[0]=2")
          .ends_with("has no 'network.stiffness' (it follows from radii and materials; a list, stiffness "
                     "= [...], has elements that can vary)"));
  BOOST_TEST(
      complaint("network.contact[0].gap=2") ==
      "--set network.contact[0].gap: the scene has no 'network.contact' (contacts of balls share the keys of "
      "[network])");
  BOOST_TEST(complaint("bodies.contact[0].gap=2")
                 .ends_with("(a table [[bodies.contact]] has what is different at one contact)"));
  BOOST_TEST(complaint("contact[0].gap=2").ends_with("the scene has no 'contact'"));
  BOOST_TEST(complaint("chain.mass.young=2") ==
             "--set chain.mass.young: 'chain.mass' is an array, not a table");
  BOOST_TEST(complaint("chain.contact[0][1]=2") ==
             "--set chain.contact[0][1]: 'chain.contact[0]' is a table, not an array");
  BOOST_TEST(complaint("[0]=2") == "--set [0]: '' is a table, not an array");
}

BOOST_AUTO_TEST_CASE(an_unreadable_override_is_named) {
  BOOST_TEST(complaint("chain.mass") == "--set chain.mass: expected KEY=VALUE");
  for (const auto* key :
       {"", ".", "chain.", "chain..mass", "chain.mass[", "chain.mass[]", "chain.mass[-1]", "chain.mass[0",
        "chain.mass[0]x", "chain.ma ss", "chain.mass[99999999999999999999]"})
    BOOST_TEST(complaint(std::string(key) + "=1") ==
               "--set " + std::string(key) +
                   ": cannot read the key (write it like chain.contact[0].stiffness)");
  std::string deep = "a";
  for (int i = 0; i < 20; ++i) deep += ".a";
  BOOST_TEST(complaint(deep + "=1") == "--set " + deep + ": the key has too many parts");
}

BOOST_AUTO_TEST_CASE(what_an_override_wrote_wrongly_is_located_there) {
  BOOST_TEST(complaint("chain.stiffnes=1") ==
             "--set chain.stiffnes: unknown key 'chain.stiffnes' (did you mean 'stiffness'?)");
  BOOST_TEST(complaint("chain.velocity[0]=2 kg") ==
             "--set chain.velocity[0]: expected a velocity (m/s), got 'kg'");
  BOOST_TEST(complaint("chain.mass=[1, 2, -3]") == "--set chain.mass: chain.mass[2]: must be positive");
}
