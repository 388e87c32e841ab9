#define BOOST_TEST_MODULE scene_equilibrium_scene
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte;
using boost::test_tools::tolerance;

namespace {

const std::string row = "mass = 1\nballs = 2\nlaw = 'hertz'\nstiffness = 1e9\n";

model::Chain chain(const std::string& text) {
  return std::get<model::Chain>(scene::parse("[chain]\n" + row + text, "s.toml").model);
}

std::string rejection(const std::string& text) {
  try {
    chain(text);
    return "accepted";
  } catch (const scene::SceneError& error) {
    return error.what();
  }
}

bool has(const std::string& text, const std::string& part) {
  BOOST_TEST_INFO(text);
  return text.find(part) != std::string::npos;
}

const std::string until = "[run]\nuntil = 1\n";

}  // namespace

BOOST_AUTO_TEST_CASE(start_and_precompression_indent_the_contacts) {
  const auto column = chain("wall = 'left'\ngravity = 10\nstart = 'equilibrium'\n" + until);
  BOOST_TEST(column.gap[0] == -std::pow(20 / 1e9, 2.0 / 3), tolerance(1e-14));
  BOOST_TEST(column.gap[1] == -std::pow(10 / 1e9, 2.0 / 3), tolerance(1e-14));
  const auto pressed = chain("wall = 'both'\nprecompression = '10 N'\n" + until);
  for (const double gap : pressed.gap) BOOST_TEST(gap == column.gap[1]);
  const auto both = chain("wall = 'both'\ngravity = 10\nprecompression = 10\n" + until);
  BOOST_TEST(both.gap[2] == pressed.gap[0]);
  BOOST_TEST(both.gap[0] == -std::pow(30 / 1e9, 2.0 / 3), tolerance(1e-14));
}

// Dampers bring them to rest: nothing would end the run.
BOOST_AUTO_TEST_CASE(balls_that_stand_on_a_wall_need_a_limit) {
  const auto read = [](const std::string& more) {
    return std::get<model::Chain>(
        scene::parse("[chain]\nmass = 1\nballs = 2\nlaw = 'kuwabara-kono'\nstiffness = "
                     "1e9\nrelaxation_time = 1e-6\nwall = 'left'\ngravity = 10\n" +
                         more,
                     "s.toml")
            .model);
  };
  const auto says = [](const scene::SceneError& error) {
    return has(error.what(), "s.toml:8:11: chain.gravity: balls that stand on a wall come to rest there");
  };
  BOOST_CHECK_EXCEPTION(read(""), scene::SceneError, says);
  BOOST_TEST(read(until).gap[0] == 0);
  BOOST_TEST(read("velocity = [0, 1]\n").velocity[2] == 1);
  BOOST_CHECK_THROW(impact::simulate(read(until)), InvalidParameter);
  const model::Chain between{.mass = {infinity, 1, infinity},
                             .law = {contact::Viscoelastic{1, 1, 1}, contact::Viscoelastic{1, 1, 1}},
                             .gap = {0, 0},
                             .velocity = {0, 0, 0},
                             .gravity = -10};
  BOOST_TEST(model::comes_to_rest(between));
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_where_it_stands) {
  BOOST_TEST(has(rejection("precompression = 10\n" + until), "s.toml:6:18: chain.precompression: "));
  BOOST_TEST(has(rejection("precompression = 10\n" + until), "walls at both ends"));
  BOOST_TEST(has(rejection("wall = 'both'\nprecompression = '10 m'\n" + until), "force"));
  BOOST_TEST(has(rejection("wall = 'both'\nprecompression = 10\n"), "needs 'run.until'"));
  BOOST_TEST(has(rejection("start = 'rest'\n" + until), "gaps, equilibrium"));
  BOOST_TEST(has(rejection("wall = 'both'\nstart = 'gaps'\nprecompression = 1\n" + until), "by its gaps"));
  BOOST_TEST(
      has(rejection("precompressed = true\nstart = 'equilibrium'\n" + until), "chain.precompressed: "));
}
