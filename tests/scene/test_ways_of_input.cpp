// Scenes as people have them: diameters, tapers, cells that repeat, single contacts, names of materials.
#define BOOST_TEST_MODULE scene_ways_of_input
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/scene/material_library.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

constexpr const char* steel =
    "material = { young = '210 GPa', poisson = 0.3, density = 7800 }\nlaw = 'hertz'\n";

scene::Scene chain(const std::string& text) {
  return scene::parse("[chain]\n" + text, "s.toml");
}

model::Chain model_of(const std::string& text) {
  return std::get<model::Chain>(chain(text).model);
}

bool refused(const std::string& text, const std::string& why) {
  try {
    scene::parse(text, "s.toml");
    return false;
  } catch (const scene::SceneError& error) {
    BOOST_TEST_INFO(error.what());
    return std::string(error.what()).find(why) != std::string::npos;
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_diameter_is_twice_a_radius) {
  BOOST_TEST(chain(std::string(steel) +
                   "balls = 2\ndiameter = '20 mm'\n[[chain.ball]]\nnumber = 2\ndiameter = '5 mm'\n")
                     .radius == (std::vector<double>{0.01, 0.0025}),
             boost::test_tools::per_element());
  BOOST_TEST(chain(std::string(steel) + "diameter = ['20 mm', '10 mm']\n").radius ==
                 (std::vector<double>{0.01, 0.005}),
             boost::test_tools::per_element());
  const auto network = scene::parse(
      "[network]\nmass = 1\nlaw = 'linear'\nstiffness = 1\ndiameter = 2\n[[network.ball]]\nposition = [0, "
      "0]\n"
      "[[network.ball]]\nposition = [1.5, 0]\ndiameter = 1\n",
      "s.toml");
  BOOST_TEST(network.radius == (std::vector<double>{1, 0.5}), boost::test_tools::per_element());
  const std::string rest = "density = 1350\n[surface]\nstiffness = 1e9\n[incidence]\nnormal_speed = 1\n";
  const auto body = scene::parse("[body]\nshape = 'sphere'\ndiameter = '5 um'\n" + rest, "s.toml");
  BOOST_TEST(std::get<model::Microbody>(body.model).body.tips[0].radius == 2.5e-6);
  BOOST_TEST(refused(std::string("[chain]\nballs = 2\nradius = 1\ndiameter = 2\n") + steel,
                     "'radius' is given, too"));
  BOOST_TEST(
      refused("[body]\nshape = 'sphere'\nradius = 1e-6\ndiameter = 2e-6\n" + rest, "'radius' is given, too"));
}

BOOST_AUTO_TEST_CASE(a_taper_multiplies_the_radius_from_ball_to_ball) {
  const auto tapered = chain(std::string(steel) + "balls = 4\nradius = 0.1\ntaper = 0.5\nwall = 'left'\n");
  BOOST_TEST(std::isinf(tapered.radius[0]));
  for (int i = 0; i < 4; ++i) {
    const double radius = 0.1 * std::pow(0.5, i);
    BOOST_TEST(tapered.radius[i + 1] == radius);
    BOOST_TEST(
        std::get<model::Chain>(tapered.model).mass[i + 1] == 4.0 / 3 * M_PI * 7800 * radius * radius * radius,
        boost::test_tools::tolerance(1e-15));
  }
  BOOST_TEST(refused("[chain]\nballs = 3\nmass = 1\ntaper = 0.9\nlaw = 'linear'\nstiffness = 1\n",
                     "does not taper"));
  BOOST_TEST(refused("[chain]\nballs = 3\ntaper = 0.9\nlaw = 'linear'\nstiffness = 1\n", "needs a radius"));
}

BOOST_AUTO_TEST_CASE(a_cell_of_balls_repeats) {
  const auto repeated =
      model_of("mass = [1, 3]\nrepeat = 3\nlaw = 'linear'\nstiffness = 1\nvelocity = [1, 0, 0, 0, 0, 0]\n");
  BOOST_TEST(repeated.mass == (std::vector<double>{1, 3, 1, 3, 1, 3}), boost::test_tools::per_element());
  BOOST_TEST(repeated.law.size() == 5u);
  const auto tapered = chain(std::string(steel) + "radius = [1, 0.5]\ntaper = 0.1\nrepeat = 2\n");
  BOOST_TEST(tapered.radius == (std::vector<double>{1, 0.5, 0.1, 0.05}), boost::test_tools::per_element());
  BOOST_TEST(model_of("mass = 2\nrepeat = 5\nlaw = 'linear'\nstiffness = 1\n").mass.size() == 5u);
  BOOST_TEST(refused("[chain]\nmass = [1, 3]\nrepeat = 2\nballs = 4\nlaw = 'linear'\nstiffness = 1\n",
                     "'balls' is given, too"));
  BOOST_TEST(
      refused("[chain]\nmass = [1, 3]\nradius = [1, 2, 3]\nrepeat = 2\nlaw = 'linear'\nstiffness = 1\n",
              "needs one value per ball that is repeated (2), got 3"));
}

BOOST_AUTO_TEST_CASE(a_contact_with_a_number_is_an_exception) {
  const auto some = model_of(
      "mass = 1\nballs = 5\nlaw = 'hertz'\nstiffness = 7\n[[chain.contact]]\nnumber = 3\nstiffness = 9\n"
      "[[chain.contact]]\nnumber = 1\nlaw = 'linear'\n");
  const double stiffness[] = {7, 7, 9, 7};
  for (int j = 0; j < 4; ++j) BOOST_TEST(contact::stiffness(some.law[j]) == stiffness[j]);
  BOOST_TEST(contact::exponent(some.law[0]) == 1);
  BOOST_TEST(contact::exponent(some.law[2]) == 1.5);
  const std::string three = "[chain]\nmass = 1\nballs = 3\nlaw = 'hertz'\nstiffness = 7\n";
  BOOST_TEST(refused(three + "[[chain.contact]]\nnumber = 3\n", "must be between 1 and 2"));
  BOOST_TEST(refused(three + "[[chain.contact]]\nnumber = 1\n[[chain.contact]]\nnumber = 1\n",
                     "contact 1 was given before"));
  BOOST_TEST(refused(three + "[[chain.contact]]\nnumber = 1\n[[chain.contact]]\nstiffness = 1\n",
                     "'number' is missing"));
}

BOOST_AUTO_TEST_CASE(a_named_material_is_its_numbers) {
  for (const auto& material : scene::named_materials()) {
    const std::string rest = "balls = 2\nradius = '1 mm'\nlaw = 'hertz'\n";
    char numbers[200];
    std::snprintf(numbers, sizeof numbers, "material = { young = %.17g, poisson = %.17g, density = %.17g }\n",
                  material.young.value, material.poisson.value, material.density.value);
    const auto by_name = model_of(rest + "material = '" + std::string(material.name) + "'\n");
    const auto by_number = model_of(rest + numbers);
    BOOST_TEST(by_name.mass == by_number.mass, boost::test_tools::per_element());
    BOOST_TEST(contact::stiffness(by_name.law[0]) == contact::stiffness(by_number.law[0]));
    BOOST_TEST((!material.young.source.empty() && !material.poisson.source.empty() &&
                !material.density.source.empty()));
  }
  BOOST_TEST(refused("[chain]\nballs = 2\nradius = 1\nlaw = 'hertz'\nmaterial = 'stell'\n",
                     "unknown material 'stell' (did you mean 'steel'?)"));
  const auto two = model_of(
      "radius = '1 mm'\nlaw = 'hertz'\nmaterial = ['steel', 'glass']\nwall = 'right'\nwall_material = "
      "'brass'\n");
  BOOST_TEST(two.mass[0] / two.mass[1] == 7830.0 / 2400, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(materials_of_body_and_surface_give_its_stiffness) {
  const auto scene = scene::parse(
      "[body]\nshape = 'sphere'\ndiameter = '5 um'\nmaterial = 'polystyrene'\n[surface]\nmaterial = "
      "'fused-silica'\n[incidence]\nnormal_speed = 5\n",
      "s.toml");
  const auto& body = std::get<model::Microbody>(scene.model);
  const double compliance = (1 - 0.4 * 0.4) / 2.9e9 + (1 - 0.17 * 0.17) / 73e9;
  BOOST_TEST(body.law[0].stiffness == 4.0 / 3 / compliance * std::sqrt(2.5e-6),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(body.body.mass == 4.0 / 3 * M_PI * 1050 * std::pow(2.5e-6, 3),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(
      refused("[body]\nshape = 'sphere'\nradius = 1e-6\ndensity = 1000\n[surface]\nmaterial = "
              "'steel'\n[incidence]\nnormal_speed = 5\n",
              "'surface.material' and 'body.material'"));
}

BOOST_AUTO_TEST_CASE(until_is_a_time_limit_that_is_wanted) {
  const std::string pair =
      "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = 'linear'\nstiffness = 1\n[run]\nuntil = '2 s'\n";
  const auto scene = scene::parse(pair, "s.toml");
  BOOST_TEST(scene.until);
  BOOST_TEST(scene.run.max_time == 2);
  BOOST_TEST(!scene::parse(pair.substr(0, pair.find("until")) + "max_time = 2\n", "s.toml").until);
  BOOST_TEST(refused(pair + "max_time = 3\n", "'max_time' is given, too"));
}
