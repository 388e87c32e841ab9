#define BOOST_TEST_MODULE scene_scene
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/sha256.hpp"
#include "support/folder.hpp"

namespace {

using namespace mariotte;

constexpr double pi = std::numbers::pi;

const std::string five_balls = R"(
title = "Five steel balls"
[chain]
radius   = "10 mm"
material = { young = "210 GPa", poisson = 0.3, density = "7800 kg/m^3" }
law      = "hertz"
balls    = 5
velocity = ["1 m/s", 0, 0, 0, 0]
gap      = 0
)";

const std::string steel = R"(
[chain]
material = { young = "210 GPa", poisson = 0.3, density = "7800 kg/m^3" }
law = "hertz"
)";

const std::string aluminium = "{ young = \"70 GPa\", poisson = 0.3, density = \"2699 kg/m^3\" }";

const model::Chain& chain(const scene::Scene& scene) {
  return std::get<model::Chain>(scene.model);
}

scene::Scene parse(const std::string& text) {
  return scene::parse(text, "f");
}

bool close(double a, double b) {
  return std::abs(a - b) <= 1e-14 * std::abs(b);
}

double steel_stiffness(double curvature) {
  return 4.0 / 3.0 / (2 * 0.91 / 210e9 * std::sqrt(curvature));
}

}  // namespace

BOOST_AUTO_TEST_CASE(five_steel_balls_resolve_to_si) {
  const auto scene = parse(five_balls);
  BOOST_TEST(scene.title == "Five steel balls");
  BOOST_TEST(chain(scene).velocity == (std::vector<double>{1, 0, 0, 0, 0}), boost::test_tools::per_element());
  BOOST_TEST(chain(scene).gap == (std::vector<double>{0, 0, 0, 0}), boost::test_tools::per_element());
  BOOST_TEST(scene.radius == (std::vector<double>(5, 0.01)), boost::test_tools::per_element());
  for (const double mass : chain(scene).mass) BOOST_TEST(close(mass, 7800 * 4e-6 / 3 * pi));
  for (const auto& law : chain(scene).law) {
    BOOST_TEST(contact::name(law) == "hertz");
    BOOST_TEST(close(contact::stiffness(law), steel_stiffness(200)));
  }
  BOOST_TEST(scene.warnings.empty());
}

BOOST_AUTO_TEST_CASE(what_a_scene_does_not_say_has_a_default) {
  const auto scene = parse("[chain]\nmass = [1, 2]\nlaw = 'linear'\nstiffness = 3\nvelocity = 1");
  BOOST_TEST(scene.title.empty());
  BOOST_TEST(scene.run.accuracy == 1e-10);
  BOOST_TEST(std::isinf(scene.run.max_time));
  BOOST_TEST(scene.run.max_events == 1000000);
  BOOST_TEST(!scene.run.flow);
  BOOST_TEST(chain(scene).gap[0] == 0);
  BOOST_TEST(chain(scene).gravity == 0);
  BOOST_TEST(!chain(scene).precompressed);
  BOOST_TEST(scene.radius.empty());
  BOOST_TEST(chain(parse("[chain]\nmass = [1, 2]\nlaw = 'linear'\nstiffness = 3")).velocity[0] == 0);
}

BOOST_AUTO_TEST_CASE(the_run_table_sets_the_options) {
  const auto scene =
      parse(five_balls + "[run]\naccuracy = 1e-8\nmax_time = '2 ms'\nmax_events = 1e3\nflow = 'taylor'");
  BOOST_TEST(scene.run.accuracy == 1e-8);
  BOOST_TEST(scene.run.max_time == 2e-3);
  BOOST_TEST(scene.run.max_events == 1000);
  BOOST_TEST((scene.run.flow == flow::Kind::taylor));
}

BOOST_AUTO_TEST_CASE(gravity_may_stand_in_the_chain_or_in_the_run) {
  BOOST_TEST(chain(parse(five_balls + "gravity = '9.81 m/s^2'")).gravity == 9.81);
  BOOST_TEST(chain(parse(five_balls + "[run]\ngravity = 9.81")).gravity == 9.81);
}

BOOST_AUTO_TEST_CASE(one_ball_of_many_may_differ) {
  const auto scene = parse(steel +
                           "radius = '10 mm'\nballs = 21\n[[chain.ball]]\nnumber = 10\nradius = '50 mm'\n"
                           "[[chain.ball]]\nnumber = 1\nvelocity = '1 m/s'\nmass = '25 g'\nmaterial = " +
                           aluminium);
  BOOST_TEST(scene.radius[9] == 0.05);
  BOOST_TEST(close(chain(scene).mass[9] / chain(scene).mass[8], 125));
  BOOST_TEST(close(contact::stiffness(chain(scene).law[8]), steel_stiffness(120)));
  BOOST_TEST(chain(scene).velocity[0] == 1);
  BOOST_TEST(chain(scene).velocity[9] == 0);
  BOOST_TEST(chain(scene).mass[0] == 0.025);
  BOOST_TEST(close(contact::stiffness(chain(scene).law[0]),
                   4.0 / 3.0 / ((0.91 / 70e9 + 0.91 / 210e9) * std::sqrt(200.0))));
}

BOOST_AUTO_TEST_CASE(values_of_balls_may_be_arrays) {
  const auto scene =
      parse("[chain]\nlaw = 'hertz'\nradius = ['10 mm', '20 mm']\nvelocity = [1, -1]\nmaterial = [" +
            aluminium + ", { young = 1e11, poisson = 0, density = 5000 }]");
  BOOST_TEST(close(chain(scene).mass[0], 2699 * 4e-6 / 3 * pi));
  BOOST_TEST(close(chain(scene).mass[1], 5000 * 32e-6 / 3 * pi));
  BOOST_TEST(
      close(contact::stiffness(chain(scene).law[0]), 4.0 / 3.0 / ((0.91 / 70e9 + 1e-11) * std::sqrt(150.0))));
}

BOOST_AUTO_TEST_CASE(a_wall_is_a_ball_of_infinite_mass_at_its_end) {
  const auto scene =
      parse(steel + "radius = '10 mm'\nvelocity = [-1, 0]\nwall = 'both'\ngap = [0.1, 0, 0.2]");
  BOOST_TEST(chain(scene).mass.size() == 4u);
  BOOST_TEST(std::isinf(chain(scene).mass.front()));
  BOOST_TEST(std::isinf(chain(scene).mass.back()));
  BOOST_TEST(std::isinf(scene.radius.front()));
  BOOST_TEST(chain(scene).velocity == (std::vector<double>{0, -1, 0, 0}), boost::test_tools::per_element());
  BOOST_TEST(chain(scene).gap == (std::vector<double>{0.1, 0, 0.2}), boost::test_tools::per_element());
  BOOST_TEST(close(contact::stiffness(chain(scene).law[0]), steel_stiffness(100)));
  BOOST_TEST(close(contact::stiffness(chain(scene).law[1]), steel_stiffness(200)));
}

BOOST_AUTO_TEST_CASE(numbers_of_balls_count_a_left_wall) {
  const auto text = steel + "radius = '10 mm'\nballs = 2\n[[chain.ball]]\nnumber = 2\nvelocity = 1\n";
  BOOST_TEST(chain(parse(text)).velocity[1] == 1);
  const auto walled = scene::parse(text, "f", {"chain.wall=left"});
  BOOST_TEST(chain(walled).velocity == (std::vector<double>{0, 1, 0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_wall_may_be_rigid_or_of_its_own_material) {
  const auto text = steel + "radius = '10 mm'\nballs = 1\nvelocity = -1\nwall = 'left'\nwall_material = ";
  BOOST_TEST(
      close(contact::stiffness(chain(parse(text + "{ young = inf }")).law[0]), 2 * steel_stiffness(100)));
  BOOST_TEST(close(contact::stiffness(chain(parse(text + aluminium)).law[0]),
                   4.0 / 3.0 / ((0.91 / 70e9 + 0.91 / 210e9) * 10)));
}

BOOST_AUTO_TEST_CASE(a_wall_beside_balls_of_many_materials_is_like_its_neighbour) {
  const auto scene =
      parse("[chain]\nlaw = 'hertz'\nradius = 0.01\nvelocity = 1\nwall = 'right'\nmaterial = [" + aluminium +
            ", { young = 1e11, poisson = 0, density = 5000 }]");
  BOOST_TEST(close(contact::stiffness(chain(scene).law[1]), 4.0 / 3.0 / (2e-11 * 10)));
}

BOOST_AUTO_TEST_CASE(a_mass_may_be_infinite_anywhere) {
  const auto scene =
      parse("[chain]\nmass = [1, inf, '2 kg']\nvelocity = [1, 0.5, 0]\nlaw = 'linear'\nstiffness = 1");
  BOOST_TEST(std::isinf(chain(scene).mass[1]));
  BOOST_TEST(chain(scene).velocity[1] == 0.5);
}

BOOST_AUTO_TEST_CASE(contacts_may_have_any_mixture_of_laws) {
  const auto scene = parse(R"([chain]
mass = [1, 2.5, 0.3, 1]
velocity = [1, 0, 0, -0.25]
[[chain.contact]]
law = "hertz"
stiffness = "3 N/m^1.5"
[[chain.contact]]
law = "viscoelastic"
stiffness = "4 N/m^2"
damping = "0.1 N s/m^2"
exponent = 2
[[chain.contact]]
law = "linear"
stiffness = "5 kN/m"
)");
  BOOST_TEST(contact::stiffness(chain(scene).law[0]) == 3);
  const auto& damped = std::get<contact::PowerLaw>(chain(scene).law[1]);
  BOOST_TEST(damped.stiffness == 4);
  BOOST_TEST(damped.damping == 0.1);
  BOOST_TEST(damped.exponent == 2);
  BOOST_TEST(contact::stiffness(chain(scene).law[2]) == 5000);
}

BOOST_AUTO_TEST_CASE(a_mixture_may_be_written_as_arrays) {
  const auto scene = parse(
      "[chain]\nvelocity = 1\nmass = 1\nlaw = ['linear', 'viscoelastic']\nstiffness = [1, 2]\n"
      "damping = [0, 0.5]\nexponent = [1, 1.25]");
  BOOST_TEST(chain(scene).mass.size() == 3u);
  BOOST_TEST(std::get<contact::PowerLaw>(chain(scene).law[1]).exponent == 1.25);
}

BOOST_AUTO_TEST_CASE(one_contact_table_stands_for_all_and_leans_on_the_chain) {
  const auto scene =
      parse("[chain]\nmass = [1, 1, 1]\nvelocity = 1\nstiffness = [3, 4]\n[[chain.contact]]\nlaw = 'linear'");
  BOOST_TEST(contact::stiffness(chain(scene).law[0]) == 3);
  BOOST_TEST(contact::stiffness(chain(scene).law[1]) == 4);
}

BOOST_AUTO_TEST_CASE(contacts_of_equal_balls_are_equal_and_others_are_not) {
  const auto scene = scene::parse(
      "[chain]\nradius = ['1 mm', '1 mm', '1 mm', '2 mm', '2 mm', '2 mm']\nlaw = 'hertz'\nmaterial = "
      "['steel', "
      "'steel', 'steel', 'steel', 'steel', 'glass']\nvelocity = [1, 0, 0, 0, 0, 0]\n",
      "s.toml");
  std::vector<double> stiffness;
  for (const auto& law : std::get<model::Chain>(scene.model).law)
    stiffness.push_back(contact::stiffness(law));
  const double root = std::sqrt(2.0);
  BOOST_TEST(stiffness[1] == stiffness[0]);
  BOOST_TEST(stiffness[2] / stiffness[0] == std::sqrt(4.0 / 3), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(stiffness[3] / stiffness[0] == root, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(stiffness[4] < stiffness[3]);
}

BOOST_AUTO_TEST_CASE(a_damped_contact_takes_its_stiffness_from_materials) {
  auto text = five_balls + "damping = 100";
  text.replace(text.find("\"hertz\""), 7, "\"viscoelastic\"");
  const auto law = std::get<contact::PowerLaw>(chain(parse(text)).law[0]);
  BOOST_TEST(close(law.stiffness, steel_stiffness(200)));
  BOOST_TEST(law.damping == 100);
  BOOST_TEST(law.exponent == 1.5);
}

BOOST_AUTO_TEST_CASE(a_precompressed_chain_may_overlap) {
  const auto scene =
      parse("[chain]\nmass = [1, 1]\nlaw = 'linear'\nstiffness = 1\ngap = -1e-3\nprecompressed = true");
  BOOST_TEST(chain(scene).gap[0] == -1e-3);
  BOOST_TEST(scene.warnings.empty());
}

BOOST_AUTO_TEST_CASE(a_million_balls_need_five_lines) {
  const auto scene =
      parse(steel + "radius = '10 mm'\nballs = 1_000_000\n[[chain.ball]]\nnumber = 1_000_000\nvelocity = -1");
  BOOST_TEST(chain(scene).mass.size() == 1000000u);
  BOOST_TEST(chain(scene).velocity.back() == -1);
  BOOST_TEST(scene.run.max_events == 10000000);  // its wave alone makes a million
}

BOOST_AUTO_TEST_CASE(sweeps_are_checked_and_left_to_others) {
  const auto scene = parse(five_balls + R"(
[[sweep]]
key = "chain.velocity[0]"
from = "0.1 m/s"
to = "10 m/s"
count = 5
scale = "log"
[[sweep]]
key = "chain.gap"
values = [0, "1 um"]
[[sweep]]
key = "run.accuracy"
from = 1
to = 2
step = 0.5
)");
  BOOST_TEST(chain(scene).velocity[0] == 1);
}

BOOST_AUTO_TEST_CASE(the_fingerprint_is_that_of_the_file_until_something_is_overridden) {
  BOOST_TEST(parse(five_balls).sha256 == scene::sha256(five_balls));
  const auto one = scene::parse(five_balls, "f", {"title=a"}).sha256;
  BOOST_TEST(one != parse(five_balls).sha256);
  BOOST_TEST(one != scene::parse(five_balls, "f", {"title=b"}).sha256);
  BOOST_TEST(one == scene::parse(five_balls, "another", {"title=a"}).sha256);
}

BOOST_AUTO_TEST_CASE(the_fingerprint_tells_of_tables_that_the_scene_names) {
  const test::Folder folder;
  const auto name = (folder.path / "s.toml").string();
  const std::string text = "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = 'tabulated'\ntable = 't.csv'\n";
  const auto print_with = [&](const std::string& rows) {
    std::ofstream(folder.path / "t.csv") << "indentation,force\n" << rows;
    return scene::parse(text, name).sha256;
  };
  const auto one = print_with("1,1\n");
  BOOST_TEST(one != scene::sha256(text));
  BOOST_TEST(one != print_with("1,2\n"));
  BOOST_TEST(one == print_with("1,1\n"));
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_no_scene_error) {
  BOOST_CHECK_THROW(scene::read("no/such/file.toml"), scene::FileError);
  BOOST_CHECK_THROW(scene::read(MARIOTTE_SCENES), scene::FileError);
}

BOOST_AUTO_TEST_CASE(every_scene_that_comes_along_is_read_without_a_warning) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MARIOTTE_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const auto scene = scene::read(entry.path().string());
    BOOST_TEST(!scene.title.empty(), entry.path());
    BOOST_TEST(scene.warnings.empty(), entry.path());
    ++count;
  }
  BOOST_TEST(count >= 6);
}
