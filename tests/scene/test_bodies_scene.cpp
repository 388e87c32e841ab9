// Scenes of bodies with friction: what is read, and what is refused.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

const std::string pair = R"([bodies]
dimension = 2
law = "hertz"
stiffness = 1e9
tangential = "mindlin"
tangential_stiffness = 1.2e9
friction = 0.1
radius = "10 mm"
mass = 0.1
[[bodies.body]]
name = "cue"
position = [0, 0]
velocity = [1, 0]
spin = "40 rad/s"
[[bodies.body]]
position = ["25 mm", 0]
)";

model::Bodies read(const std::string& text) {
  return std::get<model::Bodies>(scene::parse(text, "scene.toml").model);
}

void check_refused(const std::string& text, const std::string& words) {
  BOOST_CHECK_EXCEPTION(read(text), scene::SceneError, [&](const scene::SceneError& error) {
    const bool found = std::string(error.what()).find(words) != std::string::npos;
    if (!found) BOOST_TEST_MESSAGE(error.what());
    return found;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(balls_and_their_contact_are_read_in_si) {
  const auto bodies = read(pair);
  BOOST_TEST(bodies.dimension == 2);
  BOOST_TEST(bodies.body.size() == 2u);
  BOOST_TEST(bodies.body[0].spin.e3 == 40);
  BOOST_TEST(std::abs(bodies.body[0].inertia.e3 - 0.4 * 0.1 * 1e-4) < 1e-20);
  BOOST_TEST(bodies.contact.size() == 1u);
  BOOST_TEST(bodies.named == 0);
  BOOST_TEST(name_of(bodies, bodies.contact[0].a) == "cue");
  BOOST_TEST(name_of(bodies, bodies.contact[0].b) == "body 2");
  BOOST_TEST(bodies.contact[0].tangential.friction == 0.1);
  BOOST_TEST(std::abs(start_gap(bodies, bodies.contact[0]) - 0.005) < 1e-16);
}

BOOST_AUTO_TEST_CASE(a_table_of_one_contact_replaces_what_holds_for_all) {
  const auto bodies = read(pair + R"([[bodies.plane]]
normal = [0, 2]
point = [0, "-10 mm"]
[[bodies.contact]]
between = ["cue", "plane 1"]
friction = 0.3
share = 0
touching = true
)");
  BOOST_TEST(bodies.named == 1);
  BOOST_TEST(bodies.contact.size() == 3u);
  BOOST_TEST(bodies.contact[0].a.is_plane());
  BOOST_TEST(bodies.contact[0].tangential.friction == 0.3);
  BOOST_TEST(bodies.contact[0].share == 0);
  BOOST_TEST(start_gap(bodies, bodies.contact[0]) == 0);
  BOOST_TEST(bodies.plane[0].normal.e2 == 1);
  BOOST_TEST(bodies.contact[1].tangential.friction == 0.1);
}

BOOST_AUTO_TEST_CASE(pairs_without_a_law_do_not_touch) {
  const auto bodies = read(R"([bodies]
dimension = 3
[[bodies.body]]
radius = 1
mass = 1
position = [0, 0, 0]
[[bodies.body]]
radius = 1
mass = 1
position = [3, 0, 0]
[[bodies.body]]
radius = 1
mass = 1
position = [6, 0, 0]
[[bodies.contact]]
between = [1, 2]
law = "linear"
stiffness = 5
)");
  BOOST_TEST(bodies.contact.size() == 1u);
}

// κ/k = (3/2) k_t/k_n with k_t/k_n = 2(1 − ν)/(2 − ν) of one material.
BOOST_AUTO_TEST_CASE(mindlins_stiffness_follows_from_the_material) {
  const auto bodies = read(R"([bodies]
dimension = 2
law = "hertz"
tangential = "mindlin"
friction = 0.1
radius = 0.01
material = { young = "200 GPa", poisson = 0.3, density = 7800 }
[[bodies.body]]
position = [0, 0]
[[bodies.body]]
position = [0.03, 0]
)");
  const auto& contact = bodies.contact[0];
  BOOST_TEST(std::abs(contact.tangential.stiffness / contact::stiffness(contact.law) - 1.5 * 1.4 / 1.7) <
             1e-12);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_by_name) {
  check_refused(pair + "[[bodies.contact]]\nbetween = [\"que\", 2]\n", "no body or plane has the name 'que'");
  check_refused(pair + "[[bodies.contact]]\nbetween = [1]\n", "bodies.contact[0].between");
  check_refused(pair + "[[bodies.contact]]\nbetween = [1, 1]\n", "does not touch itself");
  check_refused(pair + "[chain]\nmass = [1, 1]\n", "a scene has a [bodies] or a [chain], not both");
  check_refused(pair + "[[bodies.body]]\nposition = [0, \"5 mm\"]\n", "overlap at the start");
  check_refused(pair + "[[bodies.body]]\nposition = [1, 0]\nquaternion = [1, 0, 0, 0]\n", "is for space");
  check_refused(pair + "[run]\ngravity = 9.81\n", "'bodies.gravity'");
  std::string far = pair;
  far.replace(far.find("\"25 mm\""), 7, "1e9");
  check_refused(far, "start nearer to the impact");
}

BOOST_AUTO_TEST_CASE(a_name_means_one_body_or_plane) {
  const std::string body = "[[bodies.body]]\nposition = [1, 0]\nname = ";
  const std::string plane = "[[bodies.plane]]\nnormal = [0, 1]\npoint = [0, -1]\n";
  for (const char* name : {"cue", "cue.1", "body 1", "body 2.1"})
    check_refused(pair + body + '"' + name + "\"\n",
                  std::string("bodies.body[2].name: another body or plane is called '") + name + "', too");
  check_refused(pair + body + "\"plane 1\"\n" + plane, "called 'plane 1', too");
  check_refused(pair + plane + "name = \"body 2\"\n", "bodies.plane[0].name: another body");
  BOOST_TEST(read(pair + body + "\"body 3\"\n").body[2].name == "body 3");
}

BOOST_AUTO_TEST_CASE(bodies_that_come_back_need_a_time_limit) {
  const std::string floor = "[[bodies.plane]]\nnormal = [0, 1]\npoint = [0, -1]\n";
  auto text = pair + floor;
  text.insert(text.find("law"), "gravity = [0, -9.81]\n");
  check_refused(text, "'run.until' or 'run.max_time' is needed");
  BOOST_TEST(read(text + "[run]\nuntil = 1\n").gravity.e2 == -9.81);
}

BOOST_AUTO_TEST_CASE(laws_that_yield_and_adhere_are_read) {
  auto text = pair;
  text.replace(text.find("law = \"hertz\"\nstiffness = 1e9\ntangential = \"mindlin\""), 52,
               "law = \"jkr\"\neffective_modulus = 1e9\neffective_radius = 5e-3\nwork_of_adhesion = 0.1\n"
               "tangential = \"spring\"");
  check_refused(text, "adhere, and may stay together for ever");
  const auto bodies = read(text + "[run]\nuntil = 1\n");
  BOOST_TEST(contact::adheres(bodies.contact[0].law));
  text.replace(text.find("\"spring\""), 8, "\"mindlin\"");
  check_refused(
      text, "beside a law that pulls, yields or ends with its indentation, friction is rigid or a spring");
}

BOOST_AUTO_TEST_CASE(corners_of_a_block_may_say_that_they_are_points) {
  const auto bodies = read(R"([bodies]
dimension = 2
law = "hertz"
stiffness = 1e9
[[bodies.body]]
shape = "block"
size = [0.1, 0.2]
radius = 0
mass = 1
position = [0, 1]
[[bodies.plane]]
normal = [0, 1]
)");
  BOOST_TEST_REQUIRE(bodies.body[0].spheres.size() == 4u);
  for (const auto& corner : bodies.body[0].spheres) BOOST_TEST(corner.radius == 0);
}

BOOST_AUTO_TEST_CASE(what_holds_for_all_pairs_is_no_list) {
  for (const std::string list :
       {"law = []", "law = [1]", "law = [\"hertz\", \"hertz\"]", "stiffness = [1e9, 1e9]", "tangential = [1]",
        "tangential_stiffness = [1.2e9]", "friction = []", "friction = [0.1, 0.2, 0.3]", "share = [1]",
        "exponent = []"}) {
    auto text = pair;
    const auto key = list.substr(0, list.find('='));
    if (const auto old = text.find("\n" + key); old != text.npos)
      text.erase(old, text.find('\n', old + 1) - old);
    text.insert(text.find("radius"), list + "\n");
    check_refused(text, "must be one value for all pairs");
  }
}

BOOST_AUTO_TEST_CASE(lists_are_refused_beside_other_errors_and_in_tables_of_contacts) {
  check_refused("[bodies]\nlaw = []\nfriction = []\nexponent = []\nbody = 1\n",
                "must be one value for all pairs");
  check_refused(pair + "[[bodies.contact]]\nbetween = [1, 2]\nfriction = [0.1]\n", "got an array");
}
