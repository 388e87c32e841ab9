#define BOOST_TEST_MODULE scene_network_scene
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "mariotte/contact/hertz.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/simulate.hpp"

namespace {

using namespace mariotte;
using Numbers = std::vector<double>;

model::Network parse(const std::string& text, const scene::Overrides& overrides = {}) {
  return std::get<model::Network>(scene::parse(text, "f", overrides).model);
}

const std::string block = R"(
[network]
mass      = [5.0, 0.0208]
velocity  = [-0.1, 1.0]
law       = "viscoelastic"
stiffness = "1e9 N/m"
damping   = "3e3 N s/m"
exponent  = 1
[[network.contact]]
direction = [1, -0.1]
[[network.contact]]
direction = [0, 0.1]
law       = "linear"
damping   = 0
stiffness = 7
gap       = "1 mm"
)";

const std::string triangle = R"(
[network]
radius   = "10 mm"
material = { young = "210 GPa", poisson = 0.3, density = "7800 kg/m^3" }
law      = "hertz"
touching = "1 nm"
[[network.ball]]
position = ["-17.3205081 mm", 0]
velocity = ["1 m/s", 0]
[[network.ball]]
position = [0, "10 mm"]
[[network.ball]]
position = [0, "-10 mm"]
radius   = "10 mm"
mass     = "1 kg"
)";

double size(const ContactDirection& direction) {
  double squared = 0;
  for (const auto& term : direction) squared += term.coefficient * term.coefficient;
  return std::sqrt(squared);
}

}  // namespace

BOOST_AUTO_TEST_CASE(freedoms_are_read_as_they_are_written) {
  const auto network = parse(block);
  BOOST_TEST(network.mass == (Numbers{5, 0.0208}));
  BOOST_TEST(network.velocity == (Numbers{-0.1, 1}));
  BOOST_TEST(network.dimension == 0);
  BOOST_TEST(network.gap == (Numbers{0, 1e-3}));
  BOOST_REQUIRE(network.direction.size() == 2U);
  BOOST_TEST(network.direction[0][1].coefficient == -0.1);
  BOOST_REQUIRE(network.direction[1].size() == 1U);  // zeros are no terms
  BOOST_TEST(network.direction[1][0].dof == 1);
  BOOST_TEST(contact::damping(network.law[0]) == 3e3);
  BOOST_TEST(contact::stiffness(network.law[1]) == 7);
}

BOOST_AUTO_TEST_CASE(a_full_mass_matrix_is_read_by_rows) {
  const auto network = parse(block, {"network.mass=[[5, 0.1], [0.1, 2]]"});
  BOOST_TEST(network.mass == (Numbers{5, 0.1, 0.1, 2}));
}

BOOST_AUTO_TEST_CASE(keys_of_the_network_may_be_one_per_contact) {
  const auto network = parse(block, {"network.gap=[0.1, 0.2]", "network.exponent=[1, 1]"});
  BOOST_TEST(network.gap == (Numbers{0.1, 1e-3}));  // that of the contact goes first
}

BOOST_AUTO_TEST_CASE(balls_that_touch_are_joined_along_their_line_of_centres) {
  const auto scene = scene::parse(triangle, "f");
  const auto& network = std::get<model::Network>(scene.model);
  BOOST_TEST(network.dimension == 2);
  BOOST_TEST(scene.radius == Numbers(3, 0.01));
  BOOST_TEST(network.gap == Numbers(3, 0.0));
  BOOST_TEST(network.velocity == (Numbers{1, 0, 0, 0, 0, 0}));
  BOOST_REQUIRE(network.direction.size() == 3U);
  for (const auto& direction : network.direction)
    BOOST_TEST(std::abs(size(direction) - std::sqrt(2)) < 1e-15);
  BOOST_TEST(std::abs(network.direction[0][0].coefficient + std::sqrt(0.75)) < 1e-8);
  BOOST_TEST(std::abs(network.direction[0][1].coefficient + 0.5) < 1e-8);
  const auto pair = model::balls_of(network, 1);
  BOOST_TEST(pair->left == 0);
  BOOST_TEST(pair->right == 2);
}

BOOST_AUTO_TEST_CASE(mass_and_stiffness_follow_from_material_unless_given) {
  const auto network = parse(triangle);
  BOOST_TEST(std::abs(network.mass[0] - 0.0326725636) < 1e-10);
  BOOST_TEST(network.mass[5] == 1);
  const contact::Elasticity steel{.young = 210e9, .poisson = 0.3};
  for (const auto& law : network.law)
    BOOST_TEST(contact::stiffness(law) == contact::hertz_stiffness(steel, 0.01, steel, 0.01));
}

BOOST_AUTO_TEST_CASE(reach_decides_which_pairs_can_touch) {
  const scene::Overrides apart = {"network.ball[0].position=[-0.0174, 0]"};
  const auto near = parse(triangle, apart);
  BOOST_REQUIRE(near.gap.size() == 3U);
  BOOST_TEST(std::abs(near.gap[0] - (std::hypot(0.0174, 0.01) - 0.02)) < 1e-15);
  BOOST_TEST(parse(triangle, {apart[0], "network.reach=1 um"}).gap.size() == 1U);
  BOOST_TEST(parse(triangle, {"network.ball[0].position=[-0.1, 0]"}).gap.size() == 1U);
}

BOOST_AUTO_TEST_CASE(balls_live_in_space_as_well_and_may_be_walls) {
  const auto network = parse(R"(
[network]
radius = 0.5
law = "linear"
stiffness = 1
[[network.ball]]
position = [0, 0, 1]
velocity = [0, 0, -1]
mass = 1
[[network.ball]]
position = [0, 0, 0]
mass = inf
)");
  BOOST_TEST(network.dimension == 3);
  BOOST_TEST(std::isinf(network.mass[3]));
  BOOST_TEST(network.gap == Numbers{0.0});
}

BOOST_AUTO_TEST_CASE(balls_that_would_pass_through_each_other_are_suspicious) {
  const auto warnings_of = [](const std::string& velocity) {
    return scene::parse(
               "[network]\nradius = 1\nmass = 1\nlaw = 'linear'\nstiffness = 1\n"
               "[[network.ball]]\nposition = [0, 0]\nvelocity = " +
                   velocity +
                   "\n"
                   "[[network.ball]]\nposition = [2, 0]\n[[network.ball]]\nposition = [0, 5]\n",
               "s.toml")
        .warnings;
  };
  BOOST_REQUIRE(warnings_of("[0, 1]").size() == 1u);
  BOOST_TEST(warnings_of("[0, 1]")[0].find("balls 1 and 3 fly towards each other from beyond 'reach'") !=
             std::string::npos);
  BOOST_TEST(warnings_of("[0.1, 1]").empty());  // it meets ball 2 first
  BOOST_TEST(warnings_of("[-1, 0]").size() == 0u);
}

BOOST_AUTO_TEST_CASE(so_are_those_that_would_do_so_after_an_impact) {
  const auto missed_if_ball_3_has = [](const std::string& velocity) {
    const auto scene = scene::parse(
        "[network]\nradius = 1\nmass = 1\nlaw = 'linear'\nstiffness = 1\n"
        "[[network.ball]]\nposition = [0, 0]\nvelocity = [1, 0]\n[[network.ball]]\nposition = [2, 0]\n"
        "[[network.ball]]\nposition = [5, 0]\nvelocity = " +
            velocity + "\n",
        "s.toml");
    BOOST_TEST(scene.warnings.empty());  // each ball of those that touch meets the other first
    return std::get<impact::NetworkImpact>(scene::simulate(scene)).missed;
  };
  BOOST_TEST((missed_if_ball_3_has("[-1, 0]") == std::vector{std::pair<Index, Index>{1, 2}}));
  BOOST_TEST((missed_if_ball_3_has("[2, 0]").empty()));
}

BOOST_AUTO_TEST_CASE(a_network_at_rest_is_suspicious) {
  BOOST_TEST(scene::parse(triangle, "f").warnings.empty());
  const auto resting = scene::parse(triangle, "f", {"network.ball[0].velocity=[0, 0]"});
  BOOST_REQUIRE(resting.warnings.size() == 1U);
  BOOST_TEST(resting.warnings[0].find("nothing moves") != std::string::npos);
}
