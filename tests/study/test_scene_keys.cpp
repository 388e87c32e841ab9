// Slopes by numbers that a scene says: through its formulas against the chain rule, and next to where it
// bends or ends.
#define BOOST_TEST_MODULE slopes by keys of a scene
#include <boost/test/unit_test.hpp>

#include "support/scene_slopes.hpp"

using namespace mariotte;
using namespace mariotte::test;

BOOST_AUTO_TEST_CASE(a_density_acts_through_masses_alone) {
  const auto by_mass = slopes_of(triplet, {"mass"}),
             by_density = slopes_of(triplet, {"chain.material.density"});
  for (const auto& outcome : by_density.outcome) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double term = slope(by_mass, impact::name_of(outcome), i) * by_mass.parameter[i].value / 7800;
      sum += term;
      size += std::abs(term);
    }
    BOOST_TEST(std::abs(outcome.slope[0].value() - sum) <= 1e-10 * size);
  }
}

BOOST_AUTO_TEST_CASE(a_stiffer_material_acts_through_stiffnesses_alone) {
  const auto by_stiffness = slopes_of(triplet, {"contact"}),
             by_young = slopes_of(triplet, {"chain.material.young"});
  for (const auto& outcome : by_young.outcome) {
    double sum = 0, size = 0;
    for (std::size_t j = 0; j < 2; ++j) {
      const double term =
          slope(by_stiffness, impact::name_of(outcome), j) * by_stiffness.parameter[j].value / 210e9;
      sum += term;
      size += std::abs(term);
    }
    BOOST_TEST(std::abs(outcome.slope[0].value() - sum) <= 1e-10 * size);
  }
}

// The damping that a restitution stands for is the root of an equation, and moves by rounding alone at some
// of the points around a number that it does not depend on.
BOOST_AUTO_TEST_CASE(dampings_of_a_restitution_may_move_by_rounding) {
  const std::string pair =
      "[chain]\nmass = [1, 2]\nvelocity = [1, 0.2]\ngap = 1e-3\nstiffness = 1e4\n"
      "restitution = 0.8\n";
  const std::tuple<std::string, std::string, double> cases[] = {
      {"law = \"viscoelastic\"\nexponent = 1\n", "chain.velocity[0]", -0.2},
      {"law = \"kelvin-voigt\"\n", "chain.velocity[0]", -0.2},
      {"law = \"kelvin-voigt\"\nat = 0.7\n", "chain.at", 0},
      {"law = \"tsuji\"\nat = 0.7\n", "chain.at", 0},
      {"law = \"tsuji\"\n", "chain.velocity[0]", -0.2},
      {"law = \"hunt-crossley\"\n", "chain.mass[0]", 0.32}};
  for (const auto& [law, key, expected] : cases)
    BOOST_TEST(std::abs(slope(slopes_of(pair + law, {key}), "velocity[0]", 0) - expected) < 1e-9, law << key);
}

// High powers of a number, as the mass of the last of many tapered balls, and small ones to an exponent.
BOOST_AUTO_TEST_CASE(steps_are_small_where_the_model_moves_fast) {
  const std::string tapered =
      "[chain]\nballs = 20\nradius = 0.01\ntaper = 0.94\nmaterial = 'steel'\n"
      "law = 'hertz'\nvelocity = [1" +
      [] {
        std::string rest;
        for (int i = 1; i < 20; ++i) rest += ", 0";
        return rest;
      }() +
      "]\n[run]\naccuracy = 1e-12\n";
  BOOST_TEST(deviation(tapered, "velocity[19]", "chain.taper") < 1e-7);
  const std::string small =
      "[chain]\nmass = [1e-12, 2e-12, 1e-12]\nlaw = \"hunt-crossley\"\nstiffness = 1e10\n"
      "damping = 100\nexponent = 3\nvelocity = [1e-3, 0, 0]\n";
  const auto by_key = slopes_of(small, {"chain.exponent"}), by_contact = slopes_of(small, {"contact"});
  double sum = 0;
  for (std::size_t i = 0; i < by_contact.parameter.size(); ++i)
    if (by_contact.parameter[i].name.ends_with("exponent")) sum += slope(by_contact, "velocity[0]", i);
  BOOST_TEST(std::abs(slope(by_key, "velocity[0]", 0) / sum - 1) < 1e-8);
}

// The model that a scene makes bends or jumps next to the number: two balls within reach of each other are so
// no more, and the speed of a restitution is that of another contact.
BOOST_AUTO_TEST_CASE(steps_stay_where_the_model_moves_smoothly) {
  const std::string rack =
      "[network]\nradius = 0.01\nmaterial = 'steel'\nlaw = 'hertz'\n[[network.ball]]\n"
      "position = [-0.02009, 0]\nvelocity = [1, 0]\n[[network.ball]]\nposition = [0, 0]\n"
      "[[network.ball]]\nposition = [0.0100005, 0.0173205080757]\n";
  for (int i = 0; i < 6; ++i)
    BOOST_TEST(slope(slopes_of(rack, {"network.ball[0].position[0]"}), "velocity[" + std::to_string(i) + "]",
                     0) == 0);
  const std::string row =
      "[chain]\nmass = [1, 2, 1.5]\nvelocity = [1, 0, -0.999]\nlaw = 'kuwabara-kono'\n"
      "stiffness = 1e4\nrestitution = 0.7\ngap = [1e-3, 2e-3]\n";
  const double expected[] = {-0.0948007, 0.2924116, 0.8023891};  // differences of runs
  for (int i = 0; i < 3; ++i) {
    const auto key = "chain.velocity[" + std::to_string(i) + "]";
    BOOST_TEST(std::abs(slope(slopes_of(row, {key}), "velocity[0]", 0) - expected[i]) < 1e-6, key);
  }
  auto symmetric = row;
  symmetric.replace(symmetric.find("-0.999"), 6, "-1");
  BOOST_CHECK_EXCEPTION(
      slopes_of(symmetric, {"chain.velocity[1]"}), scene::SceneError, [](const auto& error) {
        return std::string(error.what()).find("bends or jumps at this value") != std::string::npos;
      });
}

// A hundredth of an angle of a hundred turns is a turn, and one of a typical number is all of a short normal.
BOOST_AUTO_TEST_CASE(steps_turn_what_they_move_by_little) {
  const auto slopes_with = [](const std::string& angle, const std::string& normal, const std::string& key) {
    return slopes_of(
        "[bodies]\ndimension = 2\nlaw = 'hertz'\nstiffness = 1e9\ntangential = 'spring'\nfriction = 0.3\n"
        "tangential_stiffness = 1e5\n[[bodies.body]]\nshape = 'rod'\nradius = 0.01\nlength = 0.05\n"
        "mass = 0.1\nposition = [0, 0.04]\nvelocity = [0.3, -1]\nangle = " +
            angle + "\n[[bodies.plane]]\nnormal = [0, " + normal + "]\n",
        {key});
  };
  const std::string angle = "bodies.body[0].angle", normal = "bodies.plane[0].normal[0]";
  const auto by_angle = slopes_with("0.6", "1", angle),
             by_turns = slopes_with("628.918530717958647", "1", angle);
  const auto by_normal = slopes_with("0.6", "1", normal), by_short = slopes_with("0.6", "0.01", normal);
  for (const char* outcome : {"bodies[0].velocity[0]", "bodies[0].velocity[1]", "bodies[0].spin"}) {
    BOOST_TEST(std::abs(slope(by_turns, outcome, 0) / slope(by_angle, outcome, 0) - 1) < 1e-9);
    BOOST_TEST(std::abs(slope(by_short, outcome, 0) / slope(by_normal, outcome, 0) - 100) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(slopes_by_a_diameter_are_half_of_those_by_a_radius) {
  const std::string rest =
      "\ndensity = 1350\n[surface]\nstiffness = 1.74e9\nwork_of_adhesion = 0.38\nzeta_hertz = 1.5\n"
      "zeta_adhesion = 0.5\n[incidence]\nnormal_speed = 5\n[body]\nshape = \"sphere\"\n";
  const auto table = rest.substr(rest.find("[body]")), others = rest.substr(0, rest.find("[body]"));
  const auto by_radius = slopes_of(table + "radius = 2.45e-6" + others, {}),
             by_diameter = slopes_of(table + "diameter = 4.9e-6" + others, {});
  BOOST_TEST_REQUIRE(by_radius.parameter.size() == by_diameter.parameter.size());
  BOOST_TEST(by_diameter.parameter[0].name == "diameter");
  for (std::size_t i = 0; i < by_radius.outcome.size(); ++i) {
    const double whole = *by_radius.outcome[i].slope[0], half = *by_diameter.outcome[i].slope[0];
    BOOST_TEST(std::abs(half - 0.5 * whole) <= 1e-9 * std::abs(half));
  }
}

BOOST_AUTO_TEST_CASE(a_key_that_is_no_number_is_refused) {
  BOOST_CHECK_THROW(slopes_of(triplet, {"chain.law"}), scene::SceneError);
  BOOST_CHECK_THROW(slopes_of(triplet, {"chain.nothing"}), scene::SceneError);
}

// Of the model, as "velocity[1]", and of the scene.
BOOST_AUTO_TEST_CASE(a_number_that_is_zero_has_slopes) {
  const std::string balls =
      "[bodies]\ndimension = 2\nlaw = \"hertz\"\nstiffness = 1e9\ntangential = \"rigid\"\nfriction = 0.3\n"
      "radius = 0.01\nmass = 0.03\n[[bodies.body]]\nposition = [0, 0]\nvelocity = [1, 0.2]\nspin = 0\n"
      "[[bodies.body]]\nposition = [0.021, 0]\nvelocity = [0, 0]\n";
  const std::tuple<std::string, std::string, std::string> cases[] = {
      {triplet, "velocity[1]", "chain.velocity[1]"},
      {balls, "body[0].spin", "bodies.body[0].spin"},
      {balls, "body[1].velocity[1]", "bodies.body[1].velocity[1]"},
      {balls, "body[0].position[1]", "bodies.body[0].position[1]"}};
  for (const auto& [text, number, key] : cases) {
    const auto found = slopes_of(text, {number, key});
    BOOST_TEST_REQUIRE(found.parameter.size() == 2);
    BOOST_TEST(found.parameter[1].value == 0);
    for (const auto& outcome : found.outcome) {
      const double expected = outcome.slope[0].value();
      BOOST_TEST(std::abs(outcome.slope[1].value() - expected) <= 1e-9 * std::abs(expected) + 1e-15,
                 key << " " << name_of(outcome));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_zero_at_which_the_scene_ends_is_told_so) {
  const std::string pair =
      "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = \"hertz\"\nstiffness = 1\ngap = 0\n";
  BOOST_CHECK_EXCEPTION(slopes_of(pair, {"chain.gap"}), scene::SceneError, [](const auto& error) {
    return std::string(error.what())
        .starts_with("--to chain.gap: has no slope, since the scene ends next to it");
  });
}

// A hundredth of the height would push the ball into the plane.
BOOST_AUTO_TEST_CASE(keys_are_moved_no_farther_than_the_scene_makes_sense) {
  const std::string above =
      "[bodies]\ndimension = 2\nlaw = \"hertz\"\nstiffness = 1\n[[bodies.plane]]\nnormal = [0, 1]\n"
      "[[bodies.body]]\nradius = 1\nmass = 1\nvelocity = [0, -0.01]\nposition = [0, ";
  const std::string key = "bodies.body[0].position[1]";
  const auto slopes = slopes_of(above + "1.01]\n", {key});
  BOOST_TEST(slope(slopes, "time", 0) == 100, boost::test_tools::tolerance(1e-9));
  BOOST_CHECK_EXCEPTION(slopes_of(above + "1]\n", {key}), scene::SceneError, [&](const auto& error) {
    return std::string(error.what()).find("--to " + key + ": has no slope") != std::string::npos;
  });
}

// A radius moves mass, moment, levers and stiffness; the ball is far enough from the plane to stay so.
BOOST_AUTO_TEST_CASE(slopes_of_bodies_by_numbers_of_the_scene_are_those_of_differences) {
  const std::string sphere =
      "[bodies]\ndimension = 2\nlaw = \"hertz\"\ntangential = \"mindlin\"\nfriction = 0.09\n"
      "material = { young = \"70 GPa\", poisson = 0.25, density = \"2500 kg/m^3\" }\n"
      "[[bodies.body]]\nradius = \"2.5 mm\"\nposition = [0, \"3 mm\"]\nvelocity = [1.3, -3.7]\n"
      "[[bodies.plane]]\nnormal = [0, 1]\n";
  for (const char* outcome :
       {"bodies[0].velocity[0]", "bodies[0].spin", "contacts[0].losses.friction", "time"})
    for (const char* key : {"bodies.friction", "bodies.material.young", "bodies.body[0].velocity[1]",
                            "bodies.body[0].radius", "bodies.body[0].position[1]"})
      BOOST_TEST_CONTEXT(outcome << " by " << key) {
        const double size = std::string(outcome) == "bodies[0].spin" ? 500 : 1;
        BOOST_TEST(deviation(sphere, outcome, key) < 1e-8 * size);
      }
}
