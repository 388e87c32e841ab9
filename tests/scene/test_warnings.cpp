#define BOOST_TEST_MODULE scene_warnings
#include <boost/test/unit_test.hpp>
#include <string>

#include "mariotte/scene/scene.hpp"

namespace {

using mariotte::scene::parse;

const std::string text = R"([chain]
radius = "10 mm"
material = { young = "210 GPa", poisson = 0.3, density = "7800 kg/m^3" }
law = "hertz"
balls = 2
velocity = [1, 0]
)";

const std::string two_bodies =
    "[bodies]\nlaw = 'hertz'\nstiffness = 1\nradius = 1\ndensity = 1000\n[[bodies.body]]\n"
    "position = [0, 0]\nvelocity = [1, 0]\n[[bodies.body]]\nposition = [5000, 0]\n";

/// The only warning of a scene with one value overridden.
std::string warning(const std::string& override, const std::string& scene = text) {
  const auto warnings = parse(scene, "f", {override}).warnings;
  BOOST_TEST(warnings.size() == 1u, override);
  return warnings.empty() ? "" : warnings.front();
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_ordinary_scene_has_none) {
  BOOST_TEST(parse(text, "f").warnings.empty());
}

BOOST_AUTO_TEST_CASE(megapascals_for_steel_are_suspicious) {
  auto slip = text;
  slip.replace(slip.find("GPa"), 3, "MPa");
  const auto warnings = parse(slip, "f").warnings;
  BOOST_REQUIRE(warnings.size() == 1u);
  BOOST_TEST(warnings[0] ==
             "f:3:22: chain.material.young: below 1 GPa is very soft for this density (GPa meant?)");
}

BOOST_AUTO_TEST_CASE(slips_in_units_are_suspicious) {
  BOOST_TEST(
      warning("chain.material.young=210e12").starts_with("--set chain.material.young: stiffer than diamond"));
  BOOST_TEST(
      warning("chain.material.density=7.8").starts_with("--set chain.material.density: outside 50 to 25000"));
  BOOST_TEST(warning("chain.radius=10").starts_with("--set chain.radius: a radius of more than 1 m"));
}

BOOST_AUTO_TEST_CASE(slips_in_sizes_are_suspicious_wherever_they_stand) {
  const std::string body =
      "[body]\nshape = 'sphere'\ndiameter = 5\ndensity = 1.35\n[surface]\nlaw = 'brach-dunn'\n"
      "stiffness = 1e9\nwork_of_adhesion = 0.4\nzeta_hertz = 1\nzeta_adhesion = 1\n"
      "[incidence]\nnormal_speed = 5";
  const auto of_body = parse(body, "f").warnings;
  BOOST_REQUIRE(of_body.size() == 2u);
  BOOST_TEST(of_body[0].starts_with("f:4:11: body.density: outside 50 to 25000"));
  BOOST_TEST(of_body[1].starts_with("f:3:12: body.diameter: a radius of more than 1 mm"));
  const auto of_both = parse(two_bodies, "f", {"bodies.radius=2000", "bodies.density=1"}).warnings;
  BOOST_TEST(of_both.size() == 2u);  // said once
}

BOOST_AUTO_TEST_CASE(angles_in_degrees_are_suspicious) {
  BOOST_TEST(warning("bodies.body[0].angle=30", two_bodies)
                 .starts_with("--set bodies.body[0].angle: more than a full turn"));
}

BOOST_AUTO_TEST_CASE(accuracies_beyond_reason_are_suspicious) {
  BOOST_TEST(warning("run.accuracy=1e-15") == "--set run.accuracy: finer than double precision can give");
  BOOST_TEST(warning("run.accuracy=0.5").starts_with("--set run.accuracy: so coarse"));
}

BOOST_AUTO_TEST_CASE(a_chain_at_rest_is_suspicious) {
  BOOST_TEST(warning("chain.velocity=0") ==
             "f:1:1: chain: nothing moves: no velocity, no gravity, no compressed contact");
}

BOOST_AUTO_TEST_CASE(a_key_without_effect_is_mentioned) {
  BOOST_TEST(warning("run.impacts=2") == "--set run.impacts: has no effect without a [body]");
}

BOOST_AUTO_TEST_CASE(a_wall_of_the_same_material_does_not_repeat_a_warning) {
  const auto warnings = parse(text, "f", {"chain.wall=both", "chain.material.density=30000"}).warnings;
  BOOST_TEST(warnings.size() == 1u);
}

BOOST_AUTO_TEST_CASE(many_warnings_are_cut_short) {
  std::string many = "[chain]\nmass = 1\nlaw = 'linear'\nstiffness = 1\nvelocity = 1\nradius = [5";
  for (int i = 1; i < 1000; ++i) many += ", 5";
  const auto warnings = parse(many + "]", "f").warnings;
  BOOST_TEST(warnings.size() == 21u);
  BOOST_TEST(warnings.back() == "f: more warnings of this kind are not shown");
}
