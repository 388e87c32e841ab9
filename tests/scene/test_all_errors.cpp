// All that is wrong with a scene is told at once, each error with its place and its key.
#define BOOST_TEST_MODULE scene_all_errors
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

using Keys = std::vector<std::string>;

/// The keys of all errors, sorted; the errors are in the order of the file.
Keys wrong(const std::string& text) {
  Keys keys;
  try {
    scene::parse(text, "f");
  } catch (const scene::SceneError& error) {
    keys.push_back(error.key);
    auto last = std::pair(error.line, error.column);
    for (const auto& one : error.more) {
      BOOST_TEST(one.place.starts_with("f:"), one.what());
      BOOST_TEST((last <= std::pair(one.line, one.column)), one.what());
      last = {one.line, one.column};
      keys.push_back(one.key);
    }
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

void check(const std::string& text, const Keys& expected) {
  const auto keys = wrong(text);
  BOOST_CHECK_EQUAL_COLLECTIONS(keys.begin(), keys.end(), expected.begin(), expected.end());
}

}  // namespace

BOOST_AUTO_TEST_CASE(of_a_chain_and_its_run) {
  check(R"([chain]
colour = "red"
radius = "5 kg"
material = "steal"
velocity = ["1 m/s", "fast", "slow"]
gap = "1 s"
law = "herz"
gravity = "x"
[run]
accuracy = 5
flow = "x"
max_time = "1 m"
)",
        {"chain.colour", "chain.gap", "chain.gravity", "chain.law", "chain.material", "chain.radius",
         "chain.velocity[1]", "chain.velocity[2]", "run.accuracy", "run.flow", "run.max_time"});
}

BOOST_AUTO_TEST_CASE(of_the_laws_of_a_chain) {
  check(R"([chain]
mass = [1, 1, 1]
velocity = [1, 0, 0]
[[chain.contact]]
law = "viscoelastic"
stiffness = "1 kg"
exponent = 1
damping = "3 m"
[[chain.contact]]
law = "linear"
stiffness = -1
separation = "now"
)",
        {"chain.contact[0].damping", "chain.contact[0].stiffness", "chain.contact[1].separation",
         "chain.contact[1].stiffness"});
}

BOOST_AUTO_TEST_CASE(of_single_balls_and_drives) {
  check(R"([chain]
mass = [1, 1, 1]
law = "linear"
stiffness = 1
[[chain.ball]]
number = 1
mass = "x"
velocity = "y"
[[chain.ball]]
number = 2
radius = -1
[chain.drive]
end = "lft"
quantity = "force"
signal = "sine"
amplitude = 1
frequency = 1
[run]
until = 1
)",
        {"chain.ball[0].mass", "chain.ball[0].velocity", "chain.ball[1].radius", "chain.drive.end"});
}

BOOST_AUTO_TEST_CASE(of_a_single_ball_that_the_chain_does_not_have) {
  const std::string rest = R"(
radius = 1
material = "steel"
law = "hertz"
[[chain.ball]]
number = 5
mas = 1
radius = -1
velocity = "y"
)";
  const Keys of_ball = {"chain.ball[0].mas", "chain.ball[0].radius", "chain.ball[0].velocity"};
  check("[chain]\nballs = 6" + rest, of_ball);
  check("[chain]\nballs = 3" + rest, {of_ball[0], "chain.ball[0].number", of_ball[1], of_ball[2]});
  check("[chain]\nballs = 'x'" + rest, {of_ball[0], of_ball[1], of_ball[2], "chain.balls"});
}

BOOST_AUTO_TEST_CASE(of_a_chain_whose_number_of_balls_or_walls_is_wrong) {
  const std::string rest = R"(
radius = "5 kg"
material = "steal"
velocity = ["fast", 0, 0]
gap = [0, "1 s"]
law = "herz"
wall_material = "stel"
[[chain.ball]]
number = 2
radius = -1
[[chain.contact]]
number = 1
stiffness = "x"
)";
  const auto expected = [](Keys keys) {
    const Keys of_rest = {"chain.ball[0].radius", "chain.gap[1]", "chain.law",
                          "chain.material",       "chain.radius", "chain.velocity[0]"};
    keys.insert(keys.end(), of_rest.begin(), of_rest.end());
    std::sort(keys.begin(), keys.end());
    return keys;
  };
  check("[chain]\nwall = 'up'" + rest, expected({"chain.wall"}));
  check("[chain]\nballs = 1.5" + rest, expected({"chain.balls"}));
  check("[chain]\nrepeat = 0" + rest, expected({"chain.repeat"}));
  check("[chain]\nwall = 'up'\nballs = 'many'" + rest, expected({"chain.balls", "chain.wall"}));
}

BOOST_AUTO_TEST_CASE(of_an_array_of_the_wrong_length) {
  check("[chain]\nmass = [1, 1]\nvelocity = [1, 'fast', 0]\nlaw = 'hertz'\nstiffness = 1\n",
        {"chain.velocity", "chain.velocity[1]"});
}

BOOST_AUTO_TEST_CASE(of_bodies_whose_dimension_is_wrong) {
  check(
      "[bodies]\ndimension = 4\nlaw = 'herz'\ngravity = [0, 'x']\n[[bodies.body]]\nradius = '1 s'\nmass = "
      "1\nposition = [0, 0]\n",
      {"bodies.body[0].radius", "bodies.dimension", "bodies.gravity[1]", "bodies.law"});
}

BOOST_AUTO_TEST_CASE(of_a_microbody_of_unknown_shape) {
  check(
      "[body]\nshape = 'rd'\nradius = '1 s'\nlength_ratio = 'x'\ndensity = 1000\n[surface]\nlaw = "
      "'brach'\nstiffness = 1\nfriction = 'x'\n[incidence]\nnormal_speed = 1\n",
      {"body.length_ratio", "body.radius", "body.shape", "surface.friction", "surface.law"});
}

BOOST_AUTO_TEST_CASE(what_depends_on_a_wrong_number_of_balls_is_not_told) {
  check(
      "[chain]\nballs = 'x'\nmass = [1, 1, 1]\nvelocity = [1, 0]\ngap = [0, 0, 0]\nlaw = 'hertz'\nstiffness "
      "= 1\n",
      {"chain.balls"});
}

BOOST_AUTO_TEST_CASE(of_a_network_by_its_mass_matrix) {
  check(R"([network]
mass = [1, 1]
velocity = ["x", 0]
colour = 1
[[network.contact]]
direction = [1, -1]
law = "herz"
)",
        {"network.colour", "network.contact[0].law", "network.velocity[0]"});
}

BOOST_AUTO_TEST_CASE(of_a_network_of_balls) {
  check(R"([network]
law = "herz"
touching = "1 s"
[[network.ball]]
position = [0, 0]
radius = "1 s"
mass = "x"
[[network.ball]]
position = ["x", 0]
radius = 1
mass = 1
)",
        {"network.ball[0].mass", "network.ball[0].radius", "network.ball[1].position[0]", "network.law",
         "network.touching"});
}

BOOST_AUTO_TEST_CASE(of_bodies) {
  check(R"([bodies]
dimension = 2
law = "herz"
gravity = [0, "x"]
colour = 1
[[bodies.body]]
radius = "1 s"
mass = "x"
position = [0, 0]
velocity = [0, "1 kg"]
[[bodies.body]]
radius = 1
mass = 1
spin = "x"
[[bodies.plane]]
normal = [0, 0]
point = [0, "x"]
)",
        {"bodies.body[0].mass", "bodies.body[0].radius", "bodies.body[0].velocity[1]", "bodies.body[1].spin",
         "bodies.colour", "bodies.gravity[1]", "bodies.law", "bodies.plane[0].normal",
         "bodies.plane[0].point[1]"});
}

BOOST_AUTO_TEST_CASE(of_contacts_of_bodies) {
  check(R"([bodies]
dimension = 2
radius = 1
mass = 1
[[bodies.body]]
position = [0, 0]
[[bodies.body]]
position = [3, 0]
[[bodies.body]]
position = [6, 0]
[[bodies.contact]]
between = [1, 2]
law = "linear"
stiffness = "x"
share = 2
tangential = "glue"
[[bodies.contact]]
between = [2, 3]
law = "herz"
)",
        {"bodies.contact[0].share", "bodies.contact[0].stiffness", "bodies.contact[0].tangential",
         "bodies.contact[1].law"});
}

BOOST_AUTO_TEST_CASE(of_a_microbody) {
  check(R"([body]
shape = "rod"
radius = "1 s"
length_ratio = "x"
density = "1 m"
[surface]
stiffness = "1 s"
friction = "x"
lever = "long"
[incidence]
normal_speed = -1
spin = [1]
)",
        {"body.density", "body.length_ratio", "body.radius", "incidence.normal_speed", "incidence.spin",
         "surface.friction", "surface.lever", "surface.stiffness"});
}

BOOST_AUTO_TEST_CASE(what_a_misspelt_key_was_meant_to_say_is_not_called_missing) {
  check("[chain]\nradus = 1\nballs = 2\nlaw = 'hertz'\nvelocity = ['x', 0]\n",
        {"chain.radus", "chain.velocity[0]"});
}

BOOST_AUTO_TEST_CASE(what_many_contacts_lack_is_said_once) {
  check("[chain]\nballs = 100\nmass = 1\nlaw = 'hertz'\n", {"chain.law"});
}
