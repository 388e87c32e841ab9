#define BOOST_TEST_MODULE command_network
#include <boost/test/unit_test.hpp>

#include "session.hpp"

using support::has;
using support::Session;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Two balls in the plane whose line of centres is at 45°, and a block on two edges.
struct Networks : Session {
  Networks() {
    write("oblique.toml",
          "[network]\nradius = 0.5\nmass = 1\nlaw = \"linear\"\nstiffness = 2\ntouching = 1e-9\n"
          "[[network.ball]]\nposition = [0, 0]\nvelocity = [1, 0]\n"
          "[[network.ball]]\nposition = [0.70710678118, 0.70710678118]\n");
    write("block.toml",
          "title = \"Block\"\n[network]\nmass = [[5, 0], [0, 0.02]]\nvelocity = [-0.1, 1]\nlaw = \"linear\"\n"
          "stiffness = 1e9\n[[network.contact]]\ndirection = [1, -0.1]\n"
          "[[network.contact]]\ndirection = [1, 0.1]\n");
  }
};

}  // namespace

BOOST_FIXTURE_TEST_CASE(oblique_balls_exchange_velocity_along_their_line_of_centres, Networks) {
  const auto run = mariotte("run oblique.toml --json");
  BOOST_TEST(run.code == 0);
  const auto result = Json::parse(run.out);
  BOOST_TEST(result["model"] == "network");
  const double half[] = {0.5, -0.5, 0.5, 0.5};
  for (int i = 0; i < 4; ++i)
    BOOST_TEST(std::abs(result["final"]["velocity"][i].get<double>() - half[i]) < 1e-9);
  // A spring of stiffness 2 between two masses of 1: ω = 2, closing at √½, for π/2.
  const auto& contact = result["contacts"][0];
  BOOST_TEST(std::abs(contact["impulse"].get<double>() - std::sqrt(0.5)) < 1e-9);
  BOOST_TEST(std::abs(contact["peak_indentation"].get<double>() - std::sqrt(0.5) / 2) < 1e-9);
  BOOST_TEST(std::abs(contact["peak_force"].get<double>() - std::sqrt(0.5)) < 1e-9);
  BOOST_TEST(std::abs(contact["periods"][0][1].get<double>() - std::acos(-1.0) / 2) < 1e-9);
  BOOST_TEST(result["momentum"]["residual"].get<double>() < 1e-12);
  BOOST_TEST(result["impulse_direction"] == Json::parse("[1.0]"));
}

BOOST_FIXTURE_TEST_CASE(tables_name_balls_or_freedoms, Networks) {
  const auto balls = mariotte("run oblique.toml").out;
  BOOST_TEST(has(balls, "2 balls in the plane, 1 contact"));
  BOOST_TEST(has(balls, "1–2"));
  const auto dofs = mariotte("run block.toml").out;
  BOOST_TEST(dofs.starts_with("Block\n"));
  BOOST_TEST(has(dofs, "2 degrees of freedom, 2 contacts"));
  BOOST_TEST(has(dofs, "Impulse direction"));
}

BOOST_FIXTURE_TEST_CASE(check_shows_what_was_understood, Networks) {
  const auto shown = Json::parse(mariotte("check block.toml --json").out);
  BOOST_TEST(shown["model"] == "network");
  BOOST_TEST(shown["network"]["mass"] == Json::parse("[5.0, 0.0, 0.0, 0.02]"));
  BOOST_TEST(shown["network"]["contact"][0]["direction"] == Json::parse("[[0, 1.0], [1, -0.1]]"));
  const auto balls = Json::parse(mariotte("check oblique.toml --json").out);
  BOOST_TEST(balls["network"]["contact"][0]["balls"] == Json::parse("[1, 2]"));
  BOOST_TEST(balls["network"]["radius"].size() == 2U);
  BOOST_TEST(has(mariotte("check oblique.toml").out, "1 (1–2)"));
  BOOST_TEST(has(mariotte("check block.toml").out, "mass (diagonal)"));
}

BOOST_FIXTURE_TEST_CASE(out_holds_samples_of_every_degree_of_freedom, Networks) {
  BOOST_TEST(mariotte("run block.toml --out results").code == 0);
  const auto trace = support::content(folder / "results/trace.csv");
  BOOST_TEST(trace.starts_with("time [s],v1 [SI],v2 [SI],gap1 [m],gap2 [m],force1 [N],force2 [N]\n"));
  BOOST_TEST(std::count(trace.begin(), trace.end(), '\n') > 10);
  for (const char* name : {"result.json", "events.csv", "plot.csv", "plot.gp"})
    BOOST_TEST(fs::file_size(folder / "results" / name) > 0, name);
  BOOST_TEST(has(support::content(folder / "results/plot.gp"), "degree of freedom 1"));
  BOOST_TEST(mariotte("run oblique.toml --out balls").code == 0);
  BOOST_TEST(
      support::content(folder / "balls/trace.csv").starts_with("time [s],v1x [m/s],v1y [m/s],v2x [m/s]"));
}

BOOST_FIXTURE_TEST_CASE(accuracy_can_be_estimated, Networks) {
  const auto result = Json::parse(mariotte("run block.toml --json --estimate --accuracy 1e-7").out);
  BOOST_TEST(result["accuracy"]["estimated"].get<double>() < 1e-7);
}

BOOST_FIXTURE_TEST_CASE(the_law_gives_simulated_velocities_of_networks_back, Networks) {
  for (const char* scene : {"block.toml", "oblique.toml"}) {
    const auto law = mariotte(std::string("law ") + scene + " --json --rivals");
    BOOST_TEST(law.code == 0);
    const auto answer = Json::parse(law.out);
    BOOST_TEST(answer["status"] == "admissible");
    const auto &after = answer["final"]["velocity"], &simulated = answer["simulated"]["velocity"];
    for (std::size_t i = 0; i < after.size(); ++i)
      BOOST_TEST(std::abs(after[i].get<double>() - simulated[i].get<double>()) < 1e-9);
    BOOST_TEST(answer["rivals"].size() == 7U);
  }
  BOOST_TEST(has(mariotte("law block.toml --rivals").out, "liu-zhao-brogliato"));
}

BOOST_FIXTURE_TEST_CASE(what_turns_is_told_with_the_model_that_follows_it, Networks) {
  const char* neglected = "of themselves; [bodies] follows it.";
  BOOST_TEST(has(mariotte("run oblique.toml").out, neglected));
  BOOST_TEST(
      !has(mariotte("run oblique.toml --accuracy 1e-6 --set network.ball[0].velocity=[1,1]").out, neglected));
}

BOOST_FIXTURE_TEST_CASE(networks_can_be_swept, Networks) {
  write("sweep.toml", support::content(folder / "block.toml") +
                          "[[sweep]]\nkey = \"network.velocity[1]\"\nvalues = [0.5, 1]\n");
  const auto sweep = mariotte("sweep sweep.toml --out out --column 'final.velocity[0]'");
  BOOST_TEST(sweep.code == 0);
  const auto result = Json::parse(mariotte("run block.toml --json").out);
  const auto csv = support::content(folder / "out/sweep.csv");
  const auto last = csv.find("\n1,");
  BOOST_REQUIRE(last != std::string::npos);
  BOOST_TEST(std::abs(std::stod(csv.substr(last + 3)) - result["final"]["velocity"][0].get<double>()) <
             1e-12);
}

BOOST_FIXTURE_TEST_CASE(what_is_wrong_with_a_network_is_a_scene_error, Networks) {
  const auto run = mariotte("run block.toml --set network.mass=[5]");
  BOOST_TEST(run.code == 3);
  BOOST_TEST(has(run.err, "needs 2 values, has 1"));
}
