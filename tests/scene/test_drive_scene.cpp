// What scenes say of drives, and how they are refused.
#define BOOST_TEST_MODULE scene_drive_scene
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <numbers>

#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/simulate.hpp"
#include "support/folder.hpp"

using namespace mariotte;
using model::Driven;

namespace {

const std::string row = "[chain]\nmass = 1\nballs = 2\nlaw = 'hertz'\nstiffness = 1e9\nwall = 'left'\n";
const std::string until = "[run]\nuntil = 1\n";
const std::string sine = "signal = 'sine'\namplitude = '1 mm'\nfrequency = '2 kHz'\n";

model::Chain chain(const std::string& drive, const std::string& name = "s.toml") {
  return std::get<model::Chain>(scene::parse(row + "[chain.drive]\n" + drive + until, name).model);
}

std::string rejection_of(const std::string& text, const std::string& name = "s.toml") {
  try {
    scene::parse(text, name);
    return "accepted";
  } catch (const scene::SceneError& error) {
    return error.what();
  }
}
std::string rejection(const std::string& drive) {
  return rejection_of(row + "[chain.drive]\n" + drive + until);
}

bool has(const std::string& text, const std::string& part) {
  BOOST_TEST_INFO(text);
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sine_is_read_in_units) {
  const auto left = chain("end = 'left'\nquantity = 'position'\nphase = '90 deg'\n" + sine);
  BOOST_TEST_REQUIRE(left.drive.size() == 1);
  const auto& piece = left.drive[0].signal.piece[0];
  BOOST_TEST(piece.amplitude == 1e-3);
  BOOST_TEST(piece.frequency == 2 * std::numbers::pi * 2000);
  BOOST_TEST(piece.phase == std::numbers::pi / 2, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(left.drive[0].direction[0].dof == 0);
  const auto right = chain("end = 'right'\nquantity = 'position'\n" + sine);
  BOOST_TEST(right.drive[0].direction[0].dof == 2);
  BOOST_TEST(std::isinf(right.mass[2]));  // it was a ball
  BOOST_TEST(right.velocity[2] == 4 * std::numbers::pi, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_table_is_read_beside_the_scene) {
  const test::Folder folder;
  std::ofstream(folder.path / "push.csv") << "time [ms], force [kN]\n0, 0\n1, 2\n3, 0\n";
  const auto name = (folder.path / "s.toml").string();
  const std::string force = "end = 'right'\nquantity = 'force'\nsignal = 'table'\ntable = 'push.csv'\n";
  const auto cubic = chain(force, name);
  BOOST_TEST((cubic.drive[0].quantity == Driven::force));
  const auto linear = chain(force + "interpolation = 'linear'\n", name);
  for (const auto& one : {cubic, linear}) {
    BOOST_TEST_REQUIRE(one.drive[0].signal.piece.size() == 3);
    BOOST_TEST(one.drive[0].signal.piece[1].start == 1e-3);
    BOOST_TEST(one.drive[0].signal.piece[1].power[0] == 2000);
  }
  BOOST_TEST(linear.drive[0].signal.piece[0].power[1] == 2e6, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(cubic.drive[0].signal.piece[1].power[1] == 0);  // its highest point
  std::ofstream(folder.path / "push.csv") << "time [ms], force [kN]\n0, 0\n1, 2\n1, 0\n";
  BOOST_TEST(
      has(rejection_of(row + "[chain.drive]\n" + force + until, name), "push.csv:4:1: times of a signal"));
  std::ofstream(folder.path / "push.csv") << "time [ms], force [mm]\n0, 0\n1, 2\n";
  BOOST_TEST(has(rejection_of(row + "[chain.drive]\n" + force + until, name), "push.csv:2:4: "));
}

BOOST_AUTO_TEST_CASE(both_ends_can_be_driven) {
  const std::string left =
      "end = 'left'\nquantity = 'velocity'\nsignal = 'pulse'\namplitude = 1\nduration = 1\n";
  const std::string right =
      "end = 'right'\nquantity = 'force'\nsignal = 'pulse'\namplitude = -1\nduration = 2\n";
  const auto text = row + "[[chain.drive]]\n" + left + "[[chain.drive]]\n" + right + until;
  const auto scene = scene::parse(text, "s.toml");
  const auto impact = std::get<impact::ChainImpact>(simulate(scene));
  BOOST_TEST((impact.ending == hybrid::Ending::time_limit));
  BOOST_TEST(impact.energy.work > 0);
  BOOST_TEST(has(rejection_of(row + "[[chain.drive]]\n" + left + "[[chain.drive]]\n" + left + until),
                 "chain.drive[1].end: "));
}

BOOST_AUTO_TEST_CASE(networks_are_driven_by_their_numbers) {
  const std::string dofs =
      "[network]\nmass = [inf, 1]\nvelocity = [0, 0]\nlaw = 'linear'\nstiffness = 1\ngap = 1\n"
      "[[network.contact]]\ndirection = [-1, 1]\n";
  const std::string move =
      "[network.drive]\nnumber = 1\nquantity = 'velocity'\nsignal = 'sine'\n"
      "amplitude = 1\nfrequency = 1\nphase = 1\n";
  const auto read = [](const std::string& text) {
    return std::get<model::Network>(scene::parse(text, "s.toml").model);
  };
  BOOST_TEST(read(dofs + move + until).velocity[0] == std::sin(1.0));
  auto free = dofs + move + until;
  BOOST_TEST(has(rejection_of(free.replace(free.find("inf"), 3, "1")), "needs mass = inf"));
  const std::string balls =
      "[network]\nradius = 1\nlaw = 'linear'\nstiffness = 1\n"
      "[[network.ball]]\nposition = [0, 0]\nmass = inf\n"
      "[[network.ball]]\nposition = [2, 0]\nmass = 1\n";
  const auto shaken = read(balls + move + "direction = [0, 3]\n" + until);
  BOOST_TEST(shaken.velocity[0] == 0);
  BOOST_TEST(shaken.velocity[1] == std::sin(1.0));
  BOOST_TEST(has(rejection_of(balls + move + until), "'direction' is missing"));
  BOOST_TEST(has(rejection_of(balls + move + "direction = [0, 0]\n" + until), "network.drive.direction: "));
  BOOST_TEST(has(rejection_of(dofs + move), "needs 'run.until'"));
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_where_it_stands) {
  const std::string left = "end = 'left'\nquantity = 'position'\n";
  BOOST_TEST(
      has(rejection("end = 'left'\nquantity = 'force'\nsignal = 'pulse'\namplitude = 1\nduration = 1\n"),
          "s.toml:8:7: chain.drive.end: a force moves no wall"));
  for (const std::string angular : {"6 rad/s", "360 deg/s"})
    BOOST_TEST(has(rejection(left + "signal = 'sine'\namplitude = '1 mm'\nfrequency = '" + angular + "'\n"),
                   "counts periods"));
  BOOST_TEST(has(rejection(left + "signal = 'sine'\namplitude = '1 N'\nfrequency = 1\n"), "a length (m)"));
  BOOST_TEST(has(rejection(left + "signal = 'sine'\namplitude = 1\n"), "'frequency' is missing"));
  BOOST_TEST(has(rejection(left + sine + "duration = 1\n"), "does not belong to the signal 'sine'"));
  BOOST_TEST(has(rejection(left + sine + "number = 1\n"), "for networks"));
  BOOST_TEST(has(rejection(left + sine + "amplitud = 1\n"), "did you mean 'amplitude'"));
  BOOST_TEST(has(rejection(sine + "quantity = 'position'\n"), "'end' is missing"));
  BOOST_TEST(
      has(rejection(left + "signal = 'pulse'\namplitude = 1\nduration = 0\n"), "chain.drive.duration: "));
  BOOST_TEST(has(rejection_of(row + "[chain.drive]\n" + left + sine), "it needs 'run.until'"));
}

BOOST_AUTO_TEST_CASE(what_double_precision_cannot_follow_is_refused_where_it_stands) {
  const auto refused = [](const std::string& quantity, const std::string& signal, const std::string& place) {
    const auto what = rejection("end = 'left'\nquantity = '" + quantity + "'\n" + signal);
    return has(what, "s.toml:" + place + ": ") && has(what, "double precision");
  };
  for (const std::string quantity : {"position", "velocity"}) {
    for (const std::string fast : {"1e40", "1e100", "1e200", "1e300"}) {
      BOOST_TEST(refused(quantity, "signal = 'sine'\namplitude = 1e-8\nfrequency = " + fast + "\n",
                         "12:13: chain.drive.frequency"));
      BOOST_TEST(refused(quantity,
                         "signal = 'pulse'\namplitude = 1e-8\nduration = 1e-" + fast.substr(2) + "\n",
                         "12:12: chain.drive.duration"));
    }
    BOOST_TEST(refused(quantity, "signal = 'sine'\namplitude = 1e200\nfrequency = 10\n",
                       "11:13: chain.drive.amplitude"));
    BOOST_TEST(refused(quantity, "signal = 'sine'\namplitude = 1\nfrequency = 1e308\n", "7:1: chain.drive"));
  }
  const std::string right = "end = 'right'\nquantity = 'force'\n";
  BOOST_TEST(has(rejection(right + "signal = 'sine'\namplitude = 1\nfrequency = 1e100\n"),
                 "chain.drive.frequency: cannot be computed with in double precision"));
  BOOST_TEST(rejection(right + "signal = 'sine'\namplitude = 1\nfrequency = 1e9\n") == "accepted");
}

BOOST_AUTO_TEST_CASE(the_drive_that_cannot_be_followed_is_named) {
  const std::string push = "quantity = 'velocity'\nsignal = 'sine'\namplitude = 1e-8\nfrequency = ";
  const auto text = row + "[[chain.drive]]\nend = 'left'\n" + push + "1\n[[chain.drive]]\nend = 'right'\n" +
                    push + "1e100\n" + until;
  BOOST_TEST(has(rejection_of(text), "chain.drive[1].frequency: "));
  const std::string network =
      "[network]\nmass = [inf, 1]\nvelocity = [0, 0]\nlaw = 'linear'\nstiffness = 1\ngap = 1\n"
      "[[network.contact]]\ndirection = [-1, 1]\n[network.drive]\nnumber = 1\n";
  BOOST_TEST(has(rejection_of(network + push + "1e100\n" + until), "network.drive.frequency: "));
}
