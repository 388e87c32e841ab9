// Slopes of scenes: of microspheres against numbers computed elsewhere in extended precision, of others
// against differences and closed forms.
#define BOOST_TEST_MODULE slopes of scenes
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "mariotte/core/error.hpp"
#include "mariotte/study/sensitivity/swept_slopes.hpp"
#include "support/scene_slopes.hpp"

using namespace mariotte;
using namespace mariotte::test;
using nlohmann::json;

namespace {

std::string number(const json& value) {
  return value.dump();
}

/// A reference case as a scene.
std::string scene_of(const json& c) {
  const auto& in = c.at("inputs");
  std::string text = "[body]\nshape = \"sphere\"\nradius = " + number(in.at("radius")) +
                     "\ndensity = " + number(in.at("density")) +
                     "\n[surface]\nstiffness = " + number(in.at("stiffness")) +
                     "\nwork_of_adhesion = " + number(in.at("work_of_adhesion")) +
                     "\nfriction = " + number(in.at("friction")) + "\n";
  const std::pair<const char*, const char*> dampings[] = {{"zeta_hertz", "zeta_hertz"},
                                                          {"zeta_adhesion", "zeta_adhesion"},
                                                          {"C_H", "damping_hertz"},
                                                          {"C_A", "damping_adhesion"}};
  for (const auto& [name, key] : dampings)
    if (in.contains(name)) text += std::string(key) + " = " + number(in.at(name)) + "\n";
  return text + "[incidence]\nnormal_speed = " + number(in.at("normal_speed")) +
         "\ntangential_velocity = [0, " + number(in.at("v3")) + "]\nspin = [0, " + number(in.at("w2")) +
         ", 0]\n";
}

}  // namespace

BOOST_AUTO_TEST_CASE(slopes_of_microspheres_are_those_of_the_references) {
  std::ifstream in(std::string(MARIOTTE_TEST_DATA) + "/sensitivity/microspheres.json");
  for (const auto& c : json::parse(in)) {
    const auto found = slopes_of(scene_of(c));
    const auto names = c.at("parameters").get<std::vector<std::string>>();
    BOOST_TEST_REQUIRE(found.parameter.size() == names.size());
    for (const auto& [outcome, reference] : c.at("derivative").items())
      for (std::size_t k = 0; k < names.size(); ++k) BOOST_TEST_CONTEXT(outcome << " by " << names[k]) {
          BOOST_TEST(found.parameter[k].name == names[k]);
          const double expected = reference[k].get<double>();
          // What is zero in exact numbers is so to rounding of the outcome over its parameter.
          const double natural = std::abs(c.at("final").at(outcome).get<double>() / found.parameter[k].value);
          BOOST_TEST(std::abs(slope(found, outcome, k) - expected) <=
                     1e-8 * std::abs(expected) + 1e-13 * natural);
        }
  }
}

BOOST_AUTO_TEST_CASE(what_is_captured_has_no_slopes_of_its_rebound_or_its_time) {
  const auto found = slopes_of(
      "[body]\nshape = \"sphere\"\nradius = 2.45e-6\ndensity = 1350\n[surface]\n"
      "stiffness = 1.74e9\nwork_of_adhesion = 0.38\nzeta_hertz = 1.5\n"
      "zeta_adhesion = 0.5\n[incidence]\nnormal_speed = 0.3\n");
  BOOST_TEST((found.ending == hybrid::Ending::captured));
  int missing = 0;
  for (const auto& outcome : found.outcome)
    if (outcome.name == "contact_time" || outcome.name == "e_n")
      for (const auto& one : outcome.slope) missing += !one.has_value();
  BOOST_TEST(missing == 2 * std::ssize(found.parameter));
}

// It turns on about the tip that stays, in any instant of which it may be called captured.
BOOST_AUTO_TEST_CASE(what_still_moves_when_a_body_is_captured_has_no_slopes) {
  const auto found = slopes_of(
      "[body]\nshape = \"dumbbell\"\nradius = 7e-6\nlength_ratio = 3\ndensity = 1350\n[surface]\n"
      "law = \"brach-dunn\"\nstiffness = 1.74e9\nwork_of_adhesion = 0.05\nzeta_hertz = 225\n"
      "zeta_adhesion = 0.4\nfriction = 0\n[incidence]\nnormal_speed = 10\nangles = [0, 0.74, 0]\n",
      {"body.density"});
  BOOST_TEST((found.ending == hybrid::Ending::captured));
  for (const auto& outcome : found.outcome) {
    const bool moves = outcome.name == "normal_velocity" || outcome.name == "w2";
    const bool is_told = std::any_of(found.notes.begin(), found.notes.end(), [&](const auto& note) {
      return concerns(note, name_of(outcome), "body.density");
    });
    BOOST_TEST(outcome.slope[0].has_value() == !is_told, outcome.name);
    if (moves) BOOST_TEST(is_told, outcome.name);
  }
  BOOST_TEST(slope(found, "v3", 0) == 0);
}

// In space the direction of a slip turns ever faster until it rests. A ball rolls off with 5/7 of its speed.
BOOST_AUTO_TEST_CASE(slopes_through_a_slip_that_comes_to_rest_say_how_exact_they_are) {
  const auto found = slopes_of(
      "[bodies]\ndimension = 3\nlaw = \"hertz\"\nstiffness = 1e15\nshare = 0\ntangential = \"rigid\"\n"
      "friction = 0.54\n[[bodies.plane]]\nnormal = [0, 0, 1]\n[[bodies.contact]]\n"
      "between = [\"plane 1\", 1]\ntouching = true\n[[bodies.body]]\nshape = \"ball\"\nradius = 0.01\n"
      "mass = 0.05\nposition = [0, 0, 0.01]\nvelocity = [-0.16, 0.2, -0.97]\nspin = [15, -14, -24]\n",
      {"body[0].velocity[1]"});
  double told = 1e-9;
  for (const auto& note : found.notes)
    if (concerns(note, "bodies[0].velocity[1]", "body[0].velocity[1]")) told = std::max(told, note.error);
  BOOST_TEST(told < 1);
  BOOST_TEST(std::abs(slope(found, "bodies[0].velocity[1]", 0) - 5.0 / 7) < told);
}

// Stiff springs of a normal and a tangential contact: what is 10⁻⁵ of a radius deep has its own size. Units
// of mass change no velocity.
BOOST_AUTO_TEST_CASE(slopes_of_stiff_contacts_with_friction_are_not_rounded) {
  const std::vector<std::string> keys = {"body[0].mass",         "body[0].inertia",
                                         "body[1].mass",         "body[1].inertia",
                                         "contact[0].stiffness", "contact[0].tangential_stiffness"};
  const auto found = slopes_of(
      "[run]\naccuracy = 1e-10\n[bodies]\ndimension = 2\nlaw = \"linear\"\nstiffness = 2.3e12\n"
      "tangential = \"spring\"\nfriction = 0.48\nshare = 1\ntangential_stiffness = 3.3e12\n"
      "[[bodies.body]]\nshape = \"ball\"\nradius = 0.01\nmass = 0.054\nposition = [-0.0192, 0]\n"
      "velocity = [1, 0]\n[[bodies.body]]\nshape = \"ball\"\nradius = 0.01\nmass = 0.045\n"
      "position = [0, 0.006]\nspin = -1.8\n",
      keys);
  for (const auto* outcome : {"bodies[0].spin", "bodies[1].spin"}) {
    double sum = 0, most = 0;
    for (std::size_t c = 0; c < keys.size(); ++c) {
      const double part = found.parameter[c].value * slope(found, outcome, c);
      sum += part;
      most = std::max(most, std::abs(part));
    }
    BOOST_TEST(std::abs(sum) < 1e-11 * most);
  }
}

BOOST_AUTO_TEST_CASE(a_symmetric_chain_has_no_slopes_of_its_time) {
  const auto found =
      slopes_of("[chain]\nmass = 1\nballs = 3\nlaw = \"linear\"\nstiffness = 1\nvelocity = [1, 0, -1]\n");
  for (const auto& outcome : found.outcome)
    for (std::size_t k = 0; k < found.parameter.size(); ++k)
      if (outcome.name == "time" && found.parameter[k].name == "contact[0].stiffness")
        BOOST_TEST(!outcome.slope[k].has_value());
  BOOST_TEST(!found.notes.empty());
}

BOOST_AUTO_TEST_CASE(a_network_that_is_a_chain_has_its_slopes) {
  const std::string chain = R"([chain]
mass = [1, 2, 1.5]
law = "hertz"
stiffness = [3, 4]
velocity = [1, 0, -0.2]
gap = [0.1, 0.2]
)";
  const std::string network = R"([network]
mass = [1, 2, 1.5]
velocity = [1, 0, -0.2]
[[network.contact]]
direction = [-1, 1, 0]
gap = 0.1
law = "hertz"
stiffness = 3
[[network.contact]]
direction = [0, -1, 1]
gap = 0.2
law = "hertz"
stiffness = 4
)";
  const auto one = slopes_of(chain), other = slopes_of(network);
  BOOST_TEST_REQUIRE(one.outcome.size() == other.outcome.size());
  for (std::size_t i = 0; i < one.outcome.size(); ++i)
    for (std::size_t k = 0; k < one.parameter.size(); ++k)
      BOOST_TEST(std::abs(one.outcome[i].slope[k].value() - other.outcome[i].slope[k].value()) <= 1e-10);
}

// The last steps before a tip lets go end close to a root of its force, or meet it; slip and stick change in
// between.
BOOST_AUTO_TEST_CASE(slopes_of_rods_that_slip_stick_and_let_go_are_those_of_differences) {
  const std::string surface = "[surface]\nstiffness = 1740000000\n", run = "[run]\naccuracy = 1e-8\n";
  const std::string rod =
      run +
      "[body]\nshape = \"rod\"\nradius = 1.1236650010516209e-06\nlength_ratio = 0.77389814457114481\n"
      "density = 1350\n" +
      surface +
      "work_of_adhesion = 0.040331726028021306\nzeta_hertz = 0.35613227358715238\nfriction = "
      "0.39466424936619665\n[incidence]\nnormal_speed = 1.4504306548980674\ntangential_velocity = [0, "
      "-1.8143831217310806]\nangles = [0, 0.82642233784175856, 0]\n";
  const std::string dumbbell =
      run +
      "[body]\nshape = \"dumbbell\"\nradius = 2.4780262005563198e-06\nlength_ratio = "
      "11.549124911265427\ndensity = 1350\n" +
      surface +
      "work_of_adhesion = 0.022296306480016348\nzeta_hertz = 1.1330870577232497\nzeta_adhesion = "
      "0.14936109705555323\nfriction = 1.3597621025252731\n[incidence]\nnormal_speed = "
      "5.1100587191366191\nangles = [0, 0.26377794972106727, 0]\n";
  BOOST_TEST(deviation(rod, "normal_velocity", "body.radius") < 1e-7);
  BOOST_TEST(deviation(rod, "normal_velocity", "surface.stiffness") < 1e-7);
  BOOST_TEST(deviation(dumbbell, "normal_velocity", "surface.stiffness") < 1e-7);
}

// It sticks again while adhesion pulls, just before it lets go: there the gap moves by as much as it is with
// the steps of the parameters. The numbers are differences of the fourth order, at two distances.
BOOST_AUTO_TEST_CASE(slopes_through_a_tip_that_sticks_again_before_it_lets_go_are_those_of_differences) {
  const std::string rod =
      "[body]\nshape = \"rod\"\nradius = 2.45e-6\nlength_ratio = 2\ndensity = 1350\n[surface]\n"
      "stiffness = 1.74e9\nwork_of_adhesion = 0.01\ndamping_hertz = 0.02\nfriction = 0.5\n"
      "lever = \"indented\"\n[incidence]\nnormal_speed = 5\ntangential_velocity = [0, -5]\n"
      "angles = [0, 1.0471975511965976, 0]\n";
  for (const char* outcome : {"e_n", "v3", "w2", "normal_velocity"})
    BOOST_TEST(deviation(rod, outcome, "body.radius") < 1e-6, outcome);
  const auto found = slopes_of(rod, {"body.radius"});
  BOOST_TEST(slope(found, "e_n", 0) == 1002.509, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(slope(found, "v3", 0) == -2040.623, boost::test_tools::tolerance(1e-6));
}

// A row that lies on a wall: nothing closes with a speed, and no force jumps.
BOOST_AUTO_TEST_CASE(a_row_at_rest_on_a_wall_has_slopes) {
  const std::string row =
      "[run]\nuntil = 0.02\naccuracy = 1e-10\n[chain]\nmass = [\"inf\", 0.01, 0.02]\nlaw = \"hertz\"\n"
      "stiffness = 1e7\nvelocity = [0, 0, 0]\ngravity = 9.81\ngap = [0, 0]\n";
  for (const char* velocity : {"velocity[1]", "velocity[2]"})
    for (const char* key : {"chain.mass[1]", "chain.gravity", "chain.stiffness"})
      BOOST_TEST(deviation(row, velocity, key) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_slip_in_space_that_starts_from_rest_is_told) {
  const auto tells = [](const std::string& text) {
    const auto found = slopes_of(text, {"body.radius"});
    const auto is_it = [](const impact::SlopeNote& note) {
      return note.text.find("slip in space starts from rest") != std::string::npos;
    };
    return found.in_doubt && std::any_of(found.notes.begin(), found.notes.end(), is_it);
  };
  const std::string spatial =
      "[body]\n"
      "shape = \"rod\"\n"
      "radius = 7.5305662963596477e-06\n"
      "length_ratio = 4.3471940996362699\n"
      "density = 1350\n"
      "[surface]\n"
      "law = \"brach-dunn\"\n"
      "stiffness = 1740000000\n"
      "work_of_adhesion = 0\n"
      "damping_hertz = 0.014408130230289015\n"
      "friction = 0.64904786481809218\n"
      "[incidence]\n"
      "normal_speed = 0.40733999077262845\n"
      "tangential_velocity = [0.2928070896458696, 0.051933157143530799]\n"
      "angles = [-0.58044440764670213, -0.54566866183123952, 0.20575780568946822]\n"
      "spin = [4490.2991585846521, -7381.551049952167, 922.46050174802747]\n";
  BOOST_TEST(tells(spatial));
  auto without = spatial;
  without.replace(without.find("friction = "), 11, "friction = 0 # ");
  BOOST_TEST(!tells(without));
}

BOOST_AUTO_TEST_CASE(slopes_of_sums_of_velocities_are_swept_back) {
  const auto document = scene::parse_document(triplet, "test");
  const auto scene = resolve(document);
  const std::vector<std::string> keys = {"chain.radius", "gap", "contact[0].stiffness"};
  const auto forward = study::sensitivity(document, scene, keys);
  const auto back = study::sensitivity_of_sum(document, scene, keys, {1, 0, -2}, [] {});
  BOOST_TEST(back.is_swept_back);
  BOOST_TEST_REQUIRE(back.parameter.size() == 6);  // three radii, two gaps
  BOOST_TEST_REQUIRE(forward.parameter.size() == 6);
  for (std::size_t c = 0; c < back.parameter.size(); ++c) {
    const double value = std::max(back.parameter[c].value, 1e-6);
    const double expected = slope(forward, "velocity[0]", c) - 2 * slope(forward, "velocity[2]", c);
    BOOST_TEST(std::abs(slope(back, "sum", c) - expected) * value < 1e-9);
  }
}

// What a time limit ends in the middle of a contact moves on as the limit does.
BOOST_AUTO_TEST_CASE(slopes_by_the_time_limit_are_the_rates_at_the_end) {
  const std::string run = "[run]\naccuracy = 1e-10\nuntil = ";
  const std::string pair =
      "[chain]\nmass = [2.0, 3.0]\nvelocity = [1.5, 0]\nlaw = \"linear\"\nstiffness = 5\n";
  const auto found = slopes_of(run + "0.5\n" + pair, {"run.until"});
  const double omega = std::sqrt(5 / 1.2), force = 5 * 1.5 / omega * std::sin(omega * 0.5);
  BOOST_TEST(std::abs(slope(found, "velocity[0]", 0) + force / 2) < 1e-10);
  BOOST_TEST(std::abs(slope(found, "impulse[0]", 0) - force) < 1e-10);
  BOOST_TEST(slope(found, "time", 0) == 1);
  const auto after = slopes_of(run + "5\n" + pair, {"run.until"});
  BOOST_TEST(slope(after, "velocity[0]", 0) == 0);
  const std::string network =
      run +
      "0.5\n[network]\nmass = [2, 3]\nvelocity = [1.5, 0]\n[[network.contact]]\nlaw = \"linear\"\n"
      "stiffness = 5\ngap = 0\ndirection = [-1, 1]\n";
  BOOST_TEST(std::abs(slope(slopes_of(network, {"run.until"}), "velocity[0]", 0) + force / 2) < 1e-10);
  const std::string ball =
      run +
      "1.0\n[bodies]\ngravity = [0, -0.1]\nlaw = \"hertz\"\nstiffness = 5\ntangential = \"spring\"\n"
      "tangential_stiffness = 3\nfriction = 0.3\n[[bodies.body]]\nname = \"ball\"\nradius = 1\nmass = 1\n"
      "position = [0, 1]\nvelocity = [0.3, -1]\n[[bodies.plane]]\nname = \"floor\"\npoint = [0, 0]\nnormal = "
      "[0, 1]\n";
  BOOST_TEST(deviation(ball, "bodies[0].velocity[1]", "run.until") < 1e-8);
  BOOST_TEST(deviation(ball, "bodies[0].spin", "run.until") < 1e-8);
  const std::string sphere =
      run +
      "30e-9\n[body]\nshape = \"sphere\"\nradius = 2.45e-6\ndensity = 1350\n[surface]\nstiffness = 1.74e9\n"
      "work_of_adhesion = 0.38\nzeta_hertz = 1.5\n[incidence]\nnormal_speed = 5\n";
  BOOST_TEST(deviation(sphere, "normal_velocity", "run.until") < 1e-7);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_swept_back_is_refused) {
  BOOST_TEST(study::sweeps_back(scene::parse(triplet, "test")));
  BOOST_TEST(
      !study::sweeps_back(scene::parse(triplet + std::string("gravity = 1\nwall = \"left\"\n"), "test")));
  const auto network = scene::parse_document(
      "[network]\nmass = [1, 1]\nvelocity = [1, 0]\n"
      "[[network.contact]]\nlaw = \"linear\"\nstiffness = 1\ngap = 0\ndirection = [-1, 1]\n",
      "test");
  BOOST_TEST(!study::sweeps_back(resolve(network)));
  BOOST_CHECK_THROW(study::sensitivity_of_sum(network, resolve(network), {}, {1, 0}, [] {}),
                    InvalidParameter);
}

BOOST_AUTO_TEST_CASE(an_impact_after_a_very_long_flight_says_how_exact_its_slopes_are) {
  const auto found = slopes_of(
      "[run]\nimpacts = 3\ngravity = 9.81\naccuracy = 1e-8\n[body]\nshape = \"dumbbell\"\n"
      "radius = 9.6646814379002947e-07\nlength_ratio = 11.992948778405216\ndensity = 1350\n"
      "[surface]\nlaw = \"brach-dunn\"\nstiffness = 1740000000\nwork_of_adhesion = 0.13201246367554204\n"
      "zeta_hertz = 0.63928013448851262\nzeta_adhesion = 0\nfriction = 0\n"
      "[incidence]\nnormal_speed = 7.2374131278673604\nangles = [0, 0.94275664941287918, 0]\n"
      "spin = [0, 637352.83101089473, 0]\n",
      {"body.radius"});
  const auto tells = [](const impact::SlopeNote& note) { return note.error > 1e-6 && note.error < infinity; };
  BOOST_TEST(std::count_if(found.notes.begin(), found.notes.end(), tells) == 1);
}

// A linear contact is smooth from its onset on, so slopes need no more pieces there than the accuracy asks
// for.
BOOST_AUTO_TEST_CASE(a_rod_that_falls_on_linear_contacts_has_slopes_at_every_accuracy) {
  const auto at = [](const std::string& accuracy) {
    return slope(
        slopes_of(
            "[run]\nmax_time = 0.08\naccuracy = " + accuracy +
                "\n[bodies]\ndimension = 2\nlaw = \"linear\"\nstiffness = 186912803737.24487\nshare = 0\n"
                "tangential = \"rigid\"\nfriction = 0.024922980952437369\n[[bodies.body]]\n"
                "mass = 0.020148488124587555\nposition = [0, 0.025]\n"
                "velocity = [-0.9673928106699774, -0.91437939966270232]\nangle = -1.6421636100445522\n"
                "shape = \"rod\"\nradius = 0.005\nlength = 0.014668705140922873\n"
                "spin = -59.456639841367746\n[[bodies.plane]]\nnormal = [0, 1]\n",
            {"body[0].velocity[1]"}),
        "bodies[0].velocity[1]", 0);
  };
  BOOST_TEST(std::abs(at("1e-6") - at("1e-10")) < 1e-6);
  BOOST_TEST(std::abs(at("1e-8") - at("1e-10")) < 1e-8);
}

BOOST_AUTO_TEST_CASE(slopes_of_a_run_without_a_digit_are_left_out_with_a_note) {
  const auto found = slopes_of(
      "[network]\nmass = [1, 1, 1]\nvelocity = [-0.6306389410509874, 0.7860422678166059, "
      "-0.1683176747029167]\n"
      "law = \"linear\"\n[run]\nmax_time = 100\n"
      "[[network.contact]]\ndirection = [0.7274930810808169, 0, -0.7309372164657033]\n"
      "gap = 0.001856736083980787\nstiffness = 1000\n"
      "[[network.contact]]\ndirection = [-0.6719650032194537, 0, 0.287143297419596]\n"
      "gap = 0.001323591829275181\nstiffness = 1000\n"
      "[[network.contact]]\ndirection = [1, 0, 0]\ngap = 0.012628755614028918\nstiffness = 1000\n",
      {"mass"});
  for (const auto& outcome : found.outcome)
    for (const auto& one : outcome.slope) BOOST_TEST(!one);
  const auto tells = [](const impact::SlopeNote& note) { return note.text.ends_with("they are left out"); };
  BOOST_TEST(std::count_if(found.notes.begin(), found.notes.end(), tells) == 1);
}
