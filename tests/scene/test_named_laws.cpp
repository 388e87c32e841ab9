// The list of laws is what scenes accept and what the page of the format shows.
#define BOOST_TEST_MODULE named laws
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/report/warnings.hpp"
#include "mariotte/scene/judge.hpp"
#include "mariotte/scene/restitution.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/simulate.hpp"
#include "support/folder.hpp"

using namespace mariotte;

namespace {

const auto every_law = boost::unit_test::data::xrange(std::size(contact::named_laws));

std::string row_of_page(const contact::NamedLaw& law) {
  std::ostringstream row;
  row << "| `" << law.name << "` | " << law.force << " | ";
  for (const auto& key : law.keys)
    row << (&key == law.keys.data() ? "" : ", ") << "`" << key.key << "`"
        << (key.unit.empty() ? "" : " [" + std::string(key.unit) + "]");
  row << (law.has_table ? "`table`" : "") << " |";
  return row.str();
}

/// A number that every key takes; the largest stiffness is the last.
double value_of(std::size_t i) {
  return 2.0 + static_cast<double>(i);
}

/// Every key of the law, in base units or in those of the page.
std::string numbers_of(const contact::NamedLaw& law, bool with_units) {
  std::ostringstream text;
  for (std::size_t i = 0; i < law.keys.size(); ++i) {
    std::string unit(law.keys[i].unit);
    if (const auto n = unit.find("^n"); n != std::string::npos) unit.replace(n, 2, "^" + std::to_string(4));
    text << law.keys[i].key << " = ";
    if (law.keys[i].key == "exponent")
      text << 4;
    else if (with_units && (unit.find("^4") == std::string::npos || law.find("exponent")))
      text << "'" << value_of(i) << " " << unit << "'";
    else
      text << value_of(i);
    text << "\n";
  }
  return text.str();
}

contact::Law read(const contact::NamedLaw& law, const std::string& numbers) {
  const auto text =
      "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = '" + std::string(law.name) + "'\n" + numbers;
  return std::get<model::Chain>(scene::parse(text, "law").model).law[0];
}

}  // namespace

BOOST_DATA_TEST_CASE(the_page_shows_every_law, every_law) {
  std::ifstream file(MARIOTTE_SCENES "/../../doc/scene_format.md");
  const std::string page((std::istreambuf_iterator<char>(file)), {});
  const auto row = row_of_page(contact::named_laws[sample]);
  BOOST_TEST(page.find(row) != std::string::npos, row);
}

BOOST_DATA_TEST_CASE(scenes_name_every_law_with_the_units_of_the_page, every_law) {
  const auto& one = contact::named_laws[sample];
  if (one.has_table) return;
  for (const bool with_units : {false, true}) {
    const auto law = read(one, numbers_of(one, with_units));
    const bool is_power_law = power_law(law);
    BOOST_TEST((name(law) == one.name || is_power_law));
    for (const auto& [key, value] : parameters(law)) {
      const auto* known = one.find(key);
      if (!known) continue;
      const auto place = static_cast<std::size_t>(known - one.keys.data());
      BOOST_TEST(value == (key == "exponent" ? 4 : value_of(place)));
    }
  }
}

BOOST_DATA_TEST_CASE(a_number_that_is_missing_is_named, every_law) {
  const auto& one = contact::named_laws[sample];
  BOOST_CHECK_EXCEPTION(read(one, ""), scene::SceneError, [](const scene::SceneError& error) {
    return std::string(error.what()).find("needs") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(a_law_refuses_keys_of_others_in_a_table_of_its_own) {
  const std::string chain = "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\n[[chain.contact]]\n";
  const auto refused = [&](const std::string& contact, const std::string& words) {
    BOOST_CHECK_EXCEPTION(scene::parse(chain + contact, "law"), scene::SceneError,
                          [&](const scene::SceneError& error) {
                            return std::string(error.what()).find(words) != std::string::npos;
                          });
  };
  refused("law = 'hertz'\nstiffness = 1\nyield_pressure = 1\n", "has no yield_pressure");
  refused("law = 'walton-braun'\nloading_stiffness = 1\nunloading_stiffness = 2\nstiffness = 1\n",
          "has no stiffness");
  refused("law = 'walton-braun'\nloading_stiffness = 2\nunloading_stiffness = 1\n", "must not be below");
  refused(
      "law = 'jkr'\nseparation = 'indentation'\neffective_modulus = 1\neffective_radius = 1\n"
      "work_of_adhesion = 0.01\n",
      "has an end of its own");
}

BOOST_AUTO_TEST_CASE(keys_that_no_contact_takes_are_suspicious) {
  const auto warnings_of = [](const std::string& keys) {
    return scene::parse("[chain]\nmass = [1, 1, 1]\nvelocity = [1, 0, 0]\nstiffness = 1\n" + keys, "law")
        .warnings;
  };
  const auto idle = warnings_of("law = 'hertz'\nyield_pressure = 1\ntable = 'nowhere.csv'\n");
  BOOST_TEST_REQUIRE(idle.size() == 2u);
  BOOST_TEST(idle[0].find("chain.yield_pressure: has no effect") != std::string::npos);
  BOOST_TEST(idle[1].find("chain.table") != std::string::npos);
  BOOST_TEST(warnings_of("law = ['hertz', 'thornton']\nyield_pressure = 1\neffective_radius = 1\n"
                         "effective_modulus = 1\n")
                 .empty());
}

BOOST_AUTO_TEST_CASE(radii_alone_give_the_effective_one) {
  const auto law =
      std::get<model::Chain>(
          scene::parse("[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nradius = [1e-3, 3e-3]\nlaw = 'jkr'\n"
                       "effective_modulus = 1e9\nwork_of_adhesion = 0.1\n[run]\nuntil = 1\n",
                       "law")
              .model)
          .law[0];
  const auto radius = contact::parameters(law).at(1);
  BOOST_TEST(radius.key == "effective_radius");
  BOOST_TEST(radius.value == 0.75e-3, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(modulus_and_radius_follow_from_the_balls) {
  const auto scene = scene::parse(
      "[chain]\nradius = ['10 mm', '20 mm']\nmaterial = 'steel'\n"
      "velocity = [1, 0]\nlaw = 'thornton'\nyield_pressure = '1 GPa'\n",
      "law");
  const auto numbers = parameters(std::get<model::Chain>(scene.model).law[0]);
  BOOST_TEST(numbers.at(1).key == "effective_radius");
  BOOST_TEST(numbers.at(1).value == 0.02 / 3, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_relaxation_time_is_a_damping) {
  for (const auto& [law, n] : {std::pair{"kelvin-voigt", 1.0}, {"kuwabara-kono", 1.5}}) {
    const auto scene = scene::parse("[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = '" + std::string(law) +
                                        "'\nstiffness = 3\nrelaxation_time = '0.1 s'\n",
                                    "law");
    BOOST_TEST(damping(std::get<model::Chain>(scene.model).law[0]) == n * 0.1 * 3,
               boost::test_tools::tolerance(1e-15));
  }
}

// [Schwager & Pöschel 2007]: e of a linear contact by its damping ratio, cut off at f = 0 and at δ = 0.
BOOST_AUTO_TEST_CASE(separation_says_where_a_damped_contact_ends) {
  const double zeta = 0.3, q = std::sqrt(1 - zeta * zeta);
  const auto restitution = [&](const std::string& separation) {
    const auto text =
        "[chain]\nmass = [1, inf]\nvelocity = [1, 0]\nlaw = 'kelvin-voigt'\nstiffness = 4\n"
        "damping = " +
        std::to_string(4 * zeta) + "\nseparation = '" + separation + "'\n";
    const auto chain = std::get<model::Chain>(scene::parse(text, "law").model);
    return scene::restitution(chain.law[0], {.reduced_mass = 1, .speed = 1});
  };
  const double at_force = std::exp(-zeta / q * std::atan2(2 * zeta * q, 2 * zeta * zeta - 1));
  BOOST_TEST(std::abs(restitution("force") - at_force) < 1e-12);
  BOOST_TEST(std::abs(restitution("indentation") - std::exp(-std::numbers::pi * zeta / q)) < 1e-10);
}

BOOST_DATA_TEST_CASE(a_restitution_gives_every_law_its_damping, every_law) {
  const auto& one = contact::named_laws[sample];
  if (!one.damping()) return;
  const std::string numbers = one.find("stiffness") ? "stiffness = 3\n"
                                                    : "effective_modulus = 2\neffective_radius = 0.5\n"
                                                      "work_of_adhesion = 0.001\n";
  for (const double e : {0.4, 0.9}) {
    const auto text = "[chain]\nmass = [0.7, inf]\nvelocity = [2, 0]\nlaw = '" + std::string(one.name) +
                      "'\n" + numbers + "restitution = " + std::to_string(e) + "\nat = 1.5\n";
    const auto chain = std::get<model::Chain>(scene::parse(text, "law").model);
    const double found = scene::restitution(chain.law[0], {.reduced_mass = 0.7, .speed = 1.5});
    BOOST_TEST(std::abs(found - e) < 1e-10);
  }
}

// The force goes on straight: δ = v √(μ/k) = √(2/3) m, of a table that ends at 0.2 m.
BOOST_AUTO_TEST_CASE(a_table_that_ends_before_the_indentation_is_told) {
  const test::Folder folder;
  std::ofstream(folder.path / "curve.csv") << "indentation [m], force [N]\n0.1, 0.1\n0.2, 0.2\n";
  std::ofstream(folder.path / "pair.toml") << "[chain]\nmass = [1, 2]\nvelocity = [1, 0]\n"
                                              "law = 'tabulated'\ntable = 'curve.csv'\n";
  const auto scene = scene::read((folder.path / "pair.toml").string());
  BOOST_TEST(has_validity(scene));
  const auto impact = std::get<impact::ChainImpact>(scene::simulate(scene));
  BOOST_REQUIRE(impact.validity.table_ratio);
  BOOST_TEST(impact.validity.table_ratio->value == std::sqrt(2.0 / 3) / 0.2,
             boost::test_tools::tolerance(1e-8));
  const auto said = report::warnings(impact, {});
  BOOST_REQUIRE(said.size() == 1u);
  BOOST_TEST(said[0].find("the table has ended") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(points_of_a_tabulated_law_come_from_a_file) {
  const test::Folder folder;
  std::ofstream(folder.path / "curve.csv") << "indentation [mm], force [kN]\n0.1, 1\n0.2, 3\n0.4, 10\n";
  std::ofstream(folder.path / "pair.toml") << "[chain]\nmass = [1, inf]\nvelocity = [0.5, 0]\n"
                                              "law = 'tabulated'\ntable = 'curve.csv'\n";
  const auto law = std::get<model::Chain>(scene::read((folder.path / "pair.toml").string()).model).law[0];
  BOOST_TEST(name(law) == "tabulated");
  BOOST_TEST(contact::force(law, 2e-4, 0).value == 3000, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(scene::restitution(law, {.reduced_mass = 1, .speed = 0.5}) == 1,
             boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(a_column_that_stands_twice_in_a_table_is_refused) {
  const test::Folder folder;
  std::ofstream(folder.path / "pair.toml") << "[chain]\nmass = [1, inf]\nvelocity = [0.5, 0]\n"
                                              "law = 'tabulated'\ntable = 'curve.csv'\n";
  std::ofstream(folder.path / "curve.csv") << "indentation,force,indentation [mm]\n0.1,1,1\n0.2,3,2\n";
  BOOST_CHECK_EXCEPTION(
      scene::read((folder.path / "pair.toml").string()), scene::SceneError, [](const auto& error) {
        return std::string_view(error.what()).find("curve.csv:1:19: 'indentation' is given, too") !=
               std::string_view::npos;
      });
}

BOOST_AUTO_TEST_CASE(a_point_that_does_not_rise_is_told_by_its_line) {
  const test::Folder folder;
  std::ofstream(folder.path / "pair.toml") << "[chain]\nmass = [1, inf]\nvelocity = [0.5, 0]\n"
                                              "law = 'tabulated'\ntable = 'curve.csv'\n";
  for (const auto& [rows, line] : {std::pair{"0.1, 1\n0.2, 1\n", 3},
                                   {"0, 0\n0.2, 1\n0.1, 2\n", 4},
                                   {"0, 1\n1, 2\n", 2},
                                   {"0, 0\n\n1, 2\n2, -1\n", 5}}) {
    std::ofstream(folder.path / "curve.csv") << "indentation, force\n" << rows;
    const auto names = [place = "curve.csv:" + std::to_string(line)](const scene::SceneError& error) {
      return std::string(error.what()).find(place) != std::string::npos;
    };
    BOOST_CHECK_EXCEPTION(scene::read((folder.path / "pair.toml").string()), scene::SceneError, names);
  }
}
