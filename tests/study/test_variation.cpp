#define BOOST_TEST_MODULE study_variation
#include <boost/test/unit_test.hpp>

#include "mariotte/study/sweep/numbers.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "mariotte/study/sweep/variation.hpp"
#include "study/sweep_scenes.hpp"

using namespace mariotte;

namespace {

std::string sweep(const std::string& key, const std::string& from, const std::string& to) {
  return "[[sweep]]\nkey = '" + key + "'\nfrom = " + from + "\nto = " + to + "\ncount = 200\n";
}

study::SweepPlan plan(const std::string& text) {
  return study::read_sweep(scene::parse_document(text, "s.toml"));
}

std::vector<double> copied(scene::Scene scene) {
  std::vector<double> copy;
  for (const double* number : study::numbers(scene)) copy.push_back(*number);
  return copy;
}

bool is_direct(const std::string& text) {
  const auto one = plan(text);
  return study::find_slots(one.document, one.design).has_value();
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_that_stand_in_the_scene_are_set_without_resolving_it) {
  for (const auto* key : {"chain.velocity[2]", "chain.mass[1]", "chain.contact[1].stiffness", "chain.gap",
                          "chain.velocity", "chain.gravity"})
    BOOST_TEST(is_direct(test::three_balls + sweep(key, "0.25", "0.5")), key);
  BOOST_TEST(is_direct(test::three_balls + sweep("run.accuracy", "1e-8", "1e-6")));
}

BOOST_AUTO_TEST_CASE(what_decides_other_numbers_is_resolved_at_every_point) {
  BOOST_TEST(!is_direct(test::steel_balls + sweep("chain.radius", "0.01", "0.02")));
  BOOST_TEST(!is_direct(test::steel_balls + sweep("chain.material.young", "1e11", "2e11")));
  BOOST_TEST(!is_direct(test::steel_balls +
                        "[[sweep]]\nkey = 'chain.balls'\nfrom = 3\nto = 202\ncount = 200\n"
                        "[[sweep]]\nkey = 'chain.velocity'\nvalues = [1]\n"));
  BOOST_TEST(!is_direct(test::three_balls + sweep("run.max_events", "10", "209")));
}

/// At every point, the last one first.
void expect_scenes_of_reader(const std::string& text) {
  auto one = plan(text);
  study::Variation variation(one.document, one.design, study::find_slots(one.document, one.design));
  study::Variation slow(one.document, one.design, std::nullopt);
  for (Index point = one.design.points() - 1; point >= 0; --point) {
    const auto& scene = variation.at(point);
    const auto& expected = slow.at(point);
    BOOST_TEST(study::same_form(scene, expected));
    BOOST_TEST(copied(scene) == copied(expected), boost::test_tools::per_element());
  }
}

/// A list of so many values that are 0 but for the one at `place`.
std::string zipped(const std::string& key, int count, int place, double value) {
  std::string text = "[[sweep]]\nkey = '" + key + "'\nvalues = [";
  for (int i = 0; i < count; ++i) text += std::to_string(i == place ? value : 0.0) + ", ";
  return text + "]\n";
}

BOOST_AUTO_TEST_CASE(every_point_is_the_scene_that_the_reader_makes_of_it) {
  expect_scenes_of_reader(test::three_balls + sweep("chain.contact[1].stiffness", "0.1", "10") +
                          sweep("chain.velocity[2]", "-1", "0"));
  expect_scenes_of_reader(test::steel_balls + sweep("chain.velocity[0]", "1", "2") +
                          sweep("chain.material.young", "1e11", "2e11"));
}

BOOST_AUTO_TEST_CASE(a_value_that_other_numbers_have_by_chance_sets_its_own_alone) {
  // Where the gap is 0 it equals gravity, the other gap, and velocities.
  const auto balls = "[chain]\ngap = [0, 0]\n" + test::three_balls.substr(test::three_balls.find("mass"));
  for (const int count : {12, 300}) {
    const auto gap = zipped("chain.gap[0]", count, count / 2 + 1, 0.5);
    expect_scenes_of_reader(balls + gap);
    expect_scenes_of_reader(balls + gap + zipped("chain.gap[1]", count, 1, 0.25) + "zip = true\n");
    expect_scenes_of_reader(balls + gap + zipped("chain.velocity[2]", count, 3, -1) + "zip = true\n" +
                            sweep("chain.gravity", "0", "9.81"));
  }
  BOOST_TEST(is_direct(balls + zipped("chain.gap[0]", 300, 0, 0.5)));
  BOOST_TEST(!is_direct(balls + zipped("chain.gap[0]", 12, 7, 0.5)));  // read sooner than tried
}

BOOST_AUTO_TEST_CASE(a_damping_that_follows_from_the_largest_speed_follows_it) {
  const std::string damped =
      "[chain]\nmass = [1, 1, 1]\nvelocity = [1, 0, 0]\nlaw = 'viscoelastic'\n"
      "stiffness = 1\nrestitution = 0.8\n";
  expect_scenes_of_reader(damped + sweep("chain.velocity[1]", "-1", "0.5") +
                          sweep("chain.velocity[2]", "-2", "0"));
}

BOOST_AUTO_TEST_CASE(a_point_that_is_no_scene_is_rejected_and_the_next_one_is_not) {
  auto one = plan(test::three_balls + R"(
[[sweep]]
key = "chain.precompressed"
values = [false, true]
[[sweep]]
key = "chain.gap"
values = [0, -0.1]
)");
  study::Variation variation(one.document, one.design, study::find_slots(one.document, one.design));
  BOOST_CHECK_NO_THROW(variation.at(0));
  BOOST_CHECK_THROW(variation.at(1), scene::SceneError);
  BOOST_TEST(std::get<model::Chain>(variation.at(3).model).gap[0] == -0.1);
}
