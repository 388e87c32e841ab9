#define BOOST_TEST_MODULE command_sensitivity
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "session.hpp"

using support::has;
using support::Session;
using Json = nlohmann::json;

namespace {

const std::string triplet = std::string("sensitivity ") + MARIOTTE_SCENES + "/triplet.toml ";
const std::string sphere = std::string("sensitivity ") + MARIOTTE_SCENES + "/microsphere.toml ";

}  // namespace

BOOST_FIXTURE_TEST_CASE(json_has_a_column_per_parameter_beside_the_usual_result, Session) {
  const auto run = mariotte(triplet + "--json");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(run.err == "");
  const auto result = Json::parse(run.out);
  BOOST_TEST(result["ending"] == "separated");
  BOOST_TEST(result["parameters"][0] == "mass[0]");
  BOOST_TEST(result["parameters"].back() == "contact[1].stiffness");
  const auto columns = result["parameters"].size();
  const auto& slopes = result["derivative"];
  BOOST_TEST(slopes["velocity"].size() == 3U);
  BOOST_TEST(slopes["impulse"].size() == 2U);
  BOOST_TEST(slopes["icr"].size() == 1U);
  BOOST_TEST(slopes["time"].size() == columns);
  for (const auto& row : slopes["velocity"]) BOOST_TEST(row.size() == columns);
  // Velocities are homogeneous in velocities: ∂v/∂v₁ · v₁ = v, where the others rest.
  for (int i = 0; i < 3; ++i) {
    const double slope = slopes["velocity"][i][3], velocity = result["final"]["velocity"][i];
    BOOST_TEST(std::abs(slope - velocity) < 1e-10);
  }
}

BOOST_FIXTURE_TEST_CASE(outcomes_and_parameters_are_chosen, Session) {
  const auto run = mariotte(triplet + "--of icr --to gap --to chain.radius --csv");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(run.out.starts_with("outcome,unit,value,gap[0],gap[1],chain.radius\nicr[0],1,1.07682177037"));
  BOOST_TEST(has(mariotte(sphere + "--of e_n --to zeta_hertz").out, "zeta_hertz"));
}

BOOST_FIXTURE_TEST_CASE(outcomes_of_one_body_are_chosen, Session) {
  const auto run = mariotte(std::string("sensitivity ") + MARIOTTE_SCENES +
                            "/oblique_sphere.toml --of bodies[0] --to contact[0].friction --csv");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(
      run.out.starts_with("outcome,unit,value,contact[0].friction\nbodies[0].velocity[0],m/s,0.82498"));
  BOOST_TEST(has(run.out, "\nbodies[0].spin,rad/s,"));
  BOOST_TEST(!has(run.out, "normal_impulse"));
}

BOOST_FIXTURE_TEST_CASE(one_velocity_of_a_long_row_is_swept_back, Session) {
  const auto row =
      std::string("sensitivity ") + MARIOTTE_SCENES +
      "/solitary_wave.toml --set chain.balls=60 --to mass[7] --to chain.material.density --json ";
  const auto back = Json::parse(mariotte(row + "--of velocity[59]").out);
  const auto forward = Json::parse(mariotte(row + "--of velocity[59] --of time").out);
  BOOST_TEST(back["swept_back"] == true);
  BOOST_TEST(forward["swept_back"] == false);
  BOOST_TEST(back["parameters"] == forward["parameters"]);
  const auto& found = back["derivative"]["velocity"][0];
  const auto& expected = forward["derivative"]["velocity"][0];
  for (std::size_t c = 0; c < 2; ++c) {
    const double value = back["parameter_values"][c];
    BOOST_TEST(std::abs(found[c].get<double>() - expected[c].get<double>()) * value < 1e-9);
  }
  BOOST_TEST(std::abs(found[0].get<double>() * back["parameter_values"][0].get<double>()) > 1e-4);
}

BOOST_FIXTURE_TEST_CASE(slopes_by_all_numbers_of_a_very_long_row_are_told, Session) {
  const auto run = mariotte(std::string("sensitivity ") + MARIOTTE_SCENES +
                            "/solitary_wave.toml --set chain.balls=3000 --of velocity[2999]");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.out, "slopes by 11998 parameters, swept back"));
  BOOST_TEST(has(run.out, "contact[2998].stiffness"));
}

BOOST_FIXTURE_TEST_CASE(outcomes_are_asked_for_by_the_keys_of_results_too, Session) {
  const auto by_key =
      mariotte(triplet + "--of final.velocity[2] --of contacts[0].impulse --of final.time --csv");
  BOOST_TEST(by_key.out == mariotte(triplet + "--of velocity[2] --of impulse[0] --of time --csv").out);
  BOOST_TEST(has(by_key.out, "velocity[2],m/s,"));
}

BOOST_FIXTURE_TEST_CASE(what_there_is_no_slope_of_or_by_is_told_so, Session) {
  const auto outcome = mariotte(triplet + "--of speed");
  BOOST_TEST(outcome.code == 2);
  BOOST_TEST(has(outcome.err, "--of speed: no such outcome; there are velocity[0], "));
  const auto parameter = mariotte(triplet + "--to chain.law");
  BOOST_TEST(parameter.code == 3);
  BOOST_TEST(has(parameter.err, "--to chain.law"));
  const auto misspelt = mariotte(triplet + "--to chain.radus");
  BOOST_TEST(has(misspelt.err, "(did you mean 'chain.radius'?)"));
  const auto without_table = mariotte(triplet + "--to radius");
  BOOST_TEST(has(without_table.err, "(did you mean 'chain.radius'?)"));
  const auto beyond = mariotte(triplet + "--to 'mass[99]'");
  BOOST_TEST(beyond.code == 3);
  BOOST_TEST(has(beyond.err, "--to mass[99]: the last is mass[2] [S017]"), beyond.err);
  BOOST_TEST(has(mariotte(triplet + "--to 'contact[2].stiffness'").err, "the last is contact[1] [S017]"));
}

BOOST_FIXTURE_TEST_CASE(slopes_and_their_picture_are_written_into_a_folder, Session) {
  const auto out = (folder / "slopes").string();
  BOOST_TEST(mariotte(triplet + "--out " + out).code == 0);
  for (const char* name : {"slopes.csv", "bars.csv", "plot.gp"})
    BOOST_TEST(std::filesystem::exists(folder / "slopes" / name), name);
  const auto result = Json::parse(support::content(folder / "slopes" / "result.json"));
  BOOST_TEST(result["provenance"]["scene_sha256"].get<std::string>().size() == 64u);
  BOOST_TEST(std::string(result["provenance"]["scene"]).ends_with("triplet.toml"));
  BOOST_TEST(result["provenance"]["overrides"].empty());
  BOOST_TEST(result["derivative"]["velocity"].size() == 3u);
  BOOST_TEST(mariotte(triplet + "--out " + out).code != 0);
  BOOST_TEST(mariotte(triplet + "--force --out " + out).code == 0);
}
