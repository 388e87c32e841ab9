#define BOOST_TEST_MODULE scene_body_scene
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

const std::string rod = R"(
[body]
shape = "rod"
radius = "2.45 um"
length_ratio = 10
density = "1350 kg/m^3"
[surface]
law = "brach-dunn"
stiffness = "1.74 GPa"
work_of_adhesion = "0.38 J/m^2"
zeta_hertz = 1.5
zeta_adhesion = 0.5
friction = 0.15
[incidence]
normal_speed = "5 m/s"
angles = [0, "42 deg", 0]
)";

model::Microbody parse(const std::string& text) {
  return std::get<model::Microbody>(scene::parse(text, "scene").model);
}

bool close(double a, double b) {
  return std::abs(a - b) <= 1e-14 * std::abs(b);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_body_is_resolved_to_si) {
  const auto body = parse(rod);
  BOOST_TEST(close(body.body.mass, 7.068700102204299e-13));
  BOOST_TEST(close(body.body.inertia.e1, 2.071576121275852e-24));
  BOOST_TEST(close(body.body.inertia.e2, 4.6685338974053994e-23));
  BOOST_TEST(close(body.body.tips[1].centre.e1, 12.25e-6));
  BOOST_TEST(close(body.law[0].damping_hertz, 0.0070377708723388995));
  BOOST_TEST(close(body.law[1].damping_adhesion, 0.008722815929492133));
  BOOST_TEST(body.friction.coefficient == 0.15);
  BOOST_TEST(body.velocity.e1 == -5);
  BOOST_TEST(close(to_euler(body.attitude).beta, 42 * std::numbers::pi / 180));
}

BOOST_AUTO_TEST_CASE(what_is_left_out_is_absent) {
  const auto body = parse(R"(
[body]
shape = "sphere"
radius = 1e-6
density = 1000
[surface]
stiffness = 1e9
[incidence]
normal_speed = 1
)");
  BOOST_TEST(body.law[0].adhesion == 0);
  BOOST_TEST(body.law[0].damping_hertz == 0);
  BOOST_TEST(body.law[0].damping_adhesion == 0);
  BOOST_TEST(body.friction.coefficient == 0);
  BOOST_TEST(body.gravity == 0);
  BOOST_TEST(body.impacts == 1);
  BOOST_TEST((body.spin == Vector3{}));
}

BOOST_AUTO_TEST_CASE(damping_and_prefactors_can_be_given) {
  const auto direct = parse(rod + "spin = ['1e5 rad/s', 0, 0]\n[run]\nimpacts = 3\ngravity = '9.81 m/s^2'\n");
  BOOST_TEST(direct.spin.e1 == 1e5);
  BOOST_TEST(direct.impacts == 3);
  BOOST_TEST(direct.gravity == 9.81);
  auto text = rod;
  text.replace(text.find("zeta_hertz = 1.5"), 16, "damping_hertz = '0.01 s/m'");
  BOOST_TEST(parse(text).law[0].damping_hertz == 0.01);
  text = rod;
  text.replace(text.find("zeta_hertz = 1.5"), 16,
               "zeta_hertz = 1.5\nhertz_prefactor = 3.0241027481495146e-6");
  BOOST_TEST(close(parse(text).law[0].damping_hertz, 2 * 0.0070377708723388995));
}

BOOST_AUTO_TEST_CASE(a_custom_body_has_its_own_tips) {
  const auto body = parse(R"(
[body]
shape = "custom"
mass = "1e-13 kg"
inertia = [1e-25, 2e-24, 2.05e-24]
radius = "2 um"
tips = [{ centre = ["-10 um", 0, "1 um"] }, { centre = ["10 um", 0, 0], radius = "3 um" }]
[surface]
stiffness = "1.74 GPa"
work_of_adhesion = "0.1 J/m^2"
damping_hertz = 0.01
lever = "indented"
[incidence]
normal_speed = 1
)");
  BOOST_TEST(body.body.tips[0].radius == 2e-6);
  BOOST_TEST(body.body.tips[1].radius == 3e-6);
  BOOST_TEST(close(body.body.tips[0].centre.e3, 1e-6));
  BOOST_TEST(!model::is_symmetric(body.body));
  BOOST_TEST(body.law[1].stiffness > body.law[0].stiffness);
  BOOST_TEST((body.lever == model::Lever::indented));
}

// Adhesion alone gives back what it takes, however small the speed is beside its well.
BOOST_AUTO_TEST_CASE(without_damping_a_restitution_of_one_is_exact) {
  const auto sphere = [](double work, double speed, const char* more) {
    return "[body]\nshape = 'sphere'\nradius = 8.521e-06\ndensity = 329.2\n"
           "[surface]\nstiffness = 3.767e+10\nrestitution = 1\nwork_of_adhesion = " +
           std::to_string(work) + more + "\n[incidence]\nnormal_speed = " + std::to_string(speed) + "\n";
  };
  for (const double work : {0.0, 0.0105, 0.05, 0.2})
    for (const double speed : {0.02, 0.163, 0.7, 3.0, 11.0})
      BOOST_TEST(parse(sphere(work, speed, "")).law[0].damping_hertz == 0);
  BOOST_CHECK_THROW(parse(sphere(0.0105, 0.163, "\ndamping_adhesion = 1e-3")), scene::SceneError);
}
