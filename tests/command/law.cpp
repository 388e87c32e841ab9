#define BOOST_TEST_MODULE command_law
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>

#include "session.hpp"

using support::has;
using support::Session;
using Json = nlohmann::json;

namespace {

constexpr const char* triplet = "law --mass 1,1,1 --velocity 1,0,0 ";

double difference(const Json& a, const std::vector<double>& b) {
  double largest = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < b.size(); ++i) largest = std::max(largest, std::abs(a[i].get<double>() - b[i]));
  return largest;
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(law_answers_from_flags_alone, Session) {
  const auto run = mariotte(triplet + std::string("--icr 2 --energy-ratio 1 --json"));
  BOOST_TEST(run.code == 0);
  BOOST_TEST(run.err == "");
  const auto answer = Json::parse(run.out);
  BOOST_TEST(answer["status"] == "admissible");
  BOOST_TEST(difference(answer["final"]["velocity"], {-1.0 / 3, 2.0 / 3, 2.0 / 3}) < 1e-15);
  BOOST_TEST(std::abs(answer["contacts"][0]["impulse"].get<double>() - 4.0 / 3) < 1e-15);
  BOOST_TEST(answer["icr"] == Json::array({2.0}));
  BOOST_TEST(answer["energy"]["frame"] == "given");
}

BOOST_FIXTURE_TEST_CASE(a_velocity_too_few_is_told_so, Session) {
  const auto run = mariotte("law --mass 1,1,1 --velocity 1,0 --icr 2 --energy-ratio 1");
  BOOST_TEST(run.code == 2);
  BOOST_TEST(has(run.err, "--velocity: needs one value per mass (3), got 2"));
}

BOOST_FIXTURE_TEST_CASE(a_restitution_out_of_range_is_told_by_its_flag, Session) {
  const auto run = mariotte(triplet + std::string("--icr 2 --energy-ratio 1 --rivals --restitution -0.5"));
  BOOST_TEST(run.code == 2);
  BOOST_TEST(has(run.err, "--restitution: must be between 0 and 1, not -0.5"));
}

BOOST_FIXTURE_TEST_CASE(direction_units_and_walls_are_understood, Session) {
  const auto run =
      mariotte("law --mass '100 g,inf' --velocity '2 m/s,0' --direction 1 --energy-ratio 0.25 --json");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(difference(Json::parse(run.out)["final"]["velocity"], {-1, 0}) < 1e-15);
  const auto negative = mariotte("law --mass 1,1 --velocity -1,-2 --direction 1 --energy-ratio 1");
  BOOST_TEST(negative.code == 0);
}

BOOST_FIXTURE_TEST_CASE(frame_of_the_energy_ratio_is_named_and_counts, Session) {
  const std::string parameters = "--icr 1.5 --energy-ratio 0.9 --json";
  const auto given = Json::parse(mariotte(triplet + parameters).out);
  const auto centre = Json::parse(mariotte(triplet + parameters + " --frame mass-centre").out);
  BOOST_TEST(std::abs(given["energy"]["ratio_lab"].get<double>() - 0.9) < 1e-14);
  BOOST_TEST(std::abs(centre["energy"]["ratio_centre"].get<double>() - 0.9) < 1e-14);
  BOOST_TEST(given["final"] != centre["final"]);
  BOOST_TEST(centre["energy"]["frame"] == "mass-centre");
}

BOOST_FIXTURE_TEST_CASE(a_ratio_that_makes_energy_is_warned_of_by_its_name, Session) {
  const std::string why =
      ": above 1 the impact gains energy, which only contacts that are pressed before it can give";
  const auto flag = mariotte(triplet + std::string("--icr 2 --energy-ratio 5"));
  BOOST_TEST(flag.code == 0);
  BOOST_TEST(flag.err == "mariotte: warning: --energy-ratio" + why + "\n");
  write("law.toml", "[law]\nmass = [1, 1]\nvelocity = [1, 0]\ndirection = [1]\nenergy_ratio = 1.1\n");
  BOOST_TEST(has(mariotte("law law.toml").err, "law.energy_ratio" + why));
  BOOST_TEST(mariotte("law law.toml -q").err == "");
  BOOST_TEST(mariotte("law law.toml --energy-ratio 1").err == "");
}

BOOST_FIXTURE_TEST_CASE(what_is_inadmissible_gives_code_1_and_the_reason, Session) {
  const struct {
    const char* parameters;
    const char* status;
    const char* reason;
  } cases[] = {
      {"--icr 2.5 --energy-ratio 1", "penetrating_velocity", "contact 2 would go on closing"},
      {"--direction 1,-0.5 --energy-ratio 1", "tensile_impulse", "contact 2 would pull"},
      {"--icr 2 --energy-ratio 0.2", "complex", "at least 0.33333333333333"},
      {"--direction -1,-1 --energy-ratio 1", "no_impact", "nothing approaches"},
  };
  for (const auto& c : cases) {
    const auto run = mariotte(std::string(triplet) + c.parameters + " --json");
    BOOST_TEST(run.code == 1);
    BOOST_TEST(has(run.err, c.reason));
    BOOST_TEST(Json::parse(run.out)["status"] == c.status);
    BOOST_TEST(has(mariotte(std::string(triplet) + c.parameters).out, c.reason));
  }
}

BOOST_FIXTURE_TEST_CASE(law_of_a_simulated_scene_gives_the_simulated_velocities, Session) {
  const auto law = mariotte("law three.toml --json"), run = mariotte("run three.toml --json");
  BOOST_TEST(law.code == 0);
  const auto answer = Json::parse(law.out), result = Json::parse(run.out);
  const auto simulated = result["final"]["velocity"].get<std::vector<double>>();
  BOOST_TEST(difference(answer["final"]["velocity"], simulated) < 1e-10);
  BOOST_TEST(answer["simulated"] == Json({{"velocity", simulated}}));
  BOOST_TEST(answer["provenance"]["scene_sha256"] == result["provenance"]["scene_sha256"]);
  const auto lossy = Json::parse(mariotte("law three.toml --energy-ratio 0.8 --json").out);
  BOOST_TEST(std::abs(lossy["energy"]["ratio_lab"].get<double>() - 0.8) < 1e-14);
  BOOST_TEST(lossy["icr"] == answer["icr"]);
}

BOOST_FIXTURE_TEST_CASE(a_limit_that_stops_the_simulation_is_told_by_its_key, Session) {
  const auto until = mariotte("law three.toml --set run.until=1e-3");
  BOOST_TEST(until.code == 5);
  BOOST_TEST(until.err == "mariotte: warning: until = 0.001 s was reached before the end\n");
  BOOST_TEST(has(mariotte("law three.toml --set run.max_time=1e-3").err, "max_time = 0.001 s was reached"));
}

BOOST_FIXTURE_TEST_CASE(a_scene_with_a_law_needs_no_chain, Session) {
  write("law.toml",
        "title = \"Plain\"\n[law]\nmass = [1, 1, 1]\nvelocity = [\"1 m/s\", 0, 0]\nicr = [1.5]\n"
        "energy_ratio = 0.9\nframe = \"mass-centre\"\n");
  const auto run = mariotte("law law.toml --json");
  BOOST_TEST(run.code == 0);
  const auto answer = Json::parse(run.out);
  BOOST_TEST(answer["title"] == "Plain");
  BOOST_TEST(std::abs(answer["energy"]["ratio_centre"].get<double>() - 0.9) < 1e-14);
  BOOST_TEST(Json::parse(mariotte("law law.toml --set law.energy_ratio=1 --json").out)["energy"]["ratio"] ==
             1);
  BOOST_TEST(has(mariotte("run law.toml").err, "the scene has no [chain], [network], [body] or [bodies]"));
  BOOST_TEST(mariotte("run law.toml").code == 3);
}

BOOST_FIXTURE_TEST_CASE(rivals_answer_beside_the_law, Session) {
  const auto run = mariotte("law three.toml --rivals --json");
  BOOST_TEST(run.code == 0);
  const auto answer = Json::parse(run.out);
  std::map<std::string, Json> rivals;
  for (const auto& rival : answer["rivals"]) rivals[rival["name"]] = rival;
  BOOST_TEST(rivals.size() == 7);
  BOOST_TEST(answer["restitution"] == 1);
  BOOST_TEST(difference(rivals["newton"]["velocity"], {-1.0 / 3, 2.0 / 3, 2.0 / 3}) < 1e-14);
  BOOST_TEST(difference(rivals["by-event"]["velocity"], {0, 0, 1}) < 1e-14);
  const auto simulated = answer["simulated"]["velocity"].get<std::vector<double>>();
  BOOST_TEST(difference(rivals["liu-zhao-brogliato"]["velocity"], simulated) < 1e-8);
  const auto damped = mariotte(
      "law three.toml --rivals --json --set 'chain.contact[0].law=hunt-crossley' "
      "--set 'chain.contact[0].damping=0.1'");
  BOOST_TEST(has(damped.err, "liu-zhao-brogliato is left out"), damped.err);
  BOOST_TEST(!has(damped.out, "liu-zhao-brogliato"));
  BOOST_TEST(mariotte("law three.toml --restitution 0.5").code == 2);
  BOOST_TEST(mariotte("law three.toml --rivals --restitution 2").code == 3);
  BOOST_TEST(has(mariotte("law three.toml --rivals --restitution 0").out, "moreau"));
}

BOOST_FIXTURE_TEST_CASE(tables_stand_in_for_a_simulation, Session) {
  BOOST_TEST(mariotte("study icr-table --kappa 0.5:4:21:log --out k.csv").code == 0);
  BOOST_TEST(mariotte("study icr-table --kappa 2 --out k.csv").code == 6);  // is not overwritten
  const std::string balls = " --mass 1,1,1 --velocity 1,0,0 --json";
  const auto run = mariotte("law --table k.csv --at kappa=1.7" + balls);
  BOOST_TEST(run.code == 0);
  const auto answer = Json::parse(run.out);
  const auto exact =
      Json::parse(mariotte("run three.toml --json --set 'chain.contact=[{law = \"hertz\", stiffness = 1},"
                           "{law = \"hertz\", stiffness = 1.7}]'")
                      .out);
  const double bound = answer["interpolation"]["velocity_error"];
  BOOST_TEST(bound < 1e-2);
  BOOST_TEST(difference(answer["final"]["velocity"], exact["final"]["velocity"].get<std::vector<double>>()) <
             bound);
  const auto outside = mariotte("law --table k.csv --at kappa=5" + balls);
  BOOST_TEST(outside.code == 1);
  BOOST_TEST(has(outside.err, "kappa = 5.000000 is outside the table"));
  for (const std::string at : {"", " --at kappa", " --at speed=1,kappa=1", " --at kappa=1 --energy-ratio 1"})
    BOOST_TEST(mariotte("law --table k.csv" + at + balls).code == 2);
  write("broken.csv", "kappa,e\n");
  BOOST_TEST(mariotte("law --table broken.csv" + balls).code == 3);
  BOOST_TEST(mariotte("law --table missing.csv" + balls).code == 6);
}

BOOST_FIXTURE_TEST_CASE(a_table_is_for_its_masses_and_velocities_alone, Session) {
  BOOST_TEST(mariotte("study icr-table --kappa 1:4:4 --mass-3 0.3 --v-3 -0.5 --out k.csv").code == 0);
  const auto answer = [&](const std::string& rest) { return mariotte("law --table k.csv --at " + rest); };
  // In the frame of the second ball; 0.03/0.1 and 0.3 differ by rounding.
  BOOST_TEST(answer("kappa=2 --mass 0.1,0.1,0.03 --velocity 3,1,0").code == 0);
  const struct {
    const char* rest;
    const char* reason;
  } cases[] = {
      {"kappa=2 --mass 1,2,0.3 --velocity 1,0,-0.5", "mass-2 = 2.000000 is outside the table"},
      {"kappa=2 --mass 1,1,0.3 --velocity 1,0,0", "v-3 = 0.000000 is outside the table"},
      {"kappa=2,v-3=-0.5 --mass 1,1,0.3 --velocity 1,0,0", "--at v-3=-0.5: masses and velocities make it 0"},
      {"kappa=2 --mass 1,1,0.3 --velocity -1,0,0.5", "in the table the first ball strikes the second"},
  };
  for (const auto& c : cases) {
    const auto run = answer(c.rest);
    BOOST_TEST(run.code == 1);
    BOOST_TEST(has(run.err, c.reason), run.err);
    BOOST_TEST(has(run.err, "[L005]"));
  }
  const auto scene = mariotte("law three.toml --table k.csv --at kappa=2");
  BOOST_TEST(has(scene.err, "mass-3 = 1.000000 is outside the table"), scene.err);
  const auto twice = answer("kappa=2,kappa=3 --mass 1,1,0.3 --velocity 1,0,-0.5");
  BOOST_TEST(twice.code == 2);
  BOOST_TEST(has(twice.err, "--at: kappa is given twice [U003]"));
}

BOOST_FIXTURE_TEST_CASE(rows_of_many_balls_have_tables_too, Session) {
  const auto table = mariotte("study icr-table --balls 3:6");
  BOOST_TEST(table.code == 0);
  write("rows.csv", table.out);
  const auto run = mariotte("law --table rows.csv --at balls=4 --mass 1,1,1,1 --velocity 2,0,0,0 --json");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(Json::parse(run.out)["interpolation"]["velocity_error"] < 1e-9);
  BOOST_TEST(mariotte("law --table rows.csv --at balls=7 --mass 1,1 --velocity 1,0").code == 1);
  BOOST_TEST(mariotte("law --table rows.csv --mass 1,1,1,1 --velocity 2,0,0,0").code == 0);
  const auto heavy = mariotte("law --table rows.csv --mass 1,1,1,2 --velocity 2,0,0,0");
  BOOST_TEST(heavy.code == 1);
  BOOST_TEST(has(heavy.err, "the table is of equal balls"));
  for (const std::string bad :
       {"--balls 1", "--balls 3:2", "--balls 3 --kappa 2", "--kappa 1:2:2", "--kappa 2:1:9",
        "--kappa -1:1:9:log", "--kappa 1:2", "--law soft", "--kappa x"})
    BOOST_TEST(mariotte("study icr-table " + bad).code == 2, bad);
}

BOOST_FIXTURE_TEST_CASE(bodies_have_laws_with_friction_beside_their_first_contact, Session) {
  std::filesystem::copy(MARIOTTE_SCENES "/thrown_rod.toml", folder);
  const auto answer = Json::parse(mariotte("law thrown_rod.toml --json").out);
  std::map<std::string, Json> laws;
  for (const auto& law : answer["laws"]) laws[law["name"]] = law;
  BOOST_TEST(laws.size() == 5);
  BOOST_TEST(laws["newton"]["loss"] < 0);
  BOOST_TEST(laws["newton"]["energy_ratio"] > 1.01);
  for (const auto* name : {"simulation", "poisson", "moreau", "stronge"})
    BOOST_TEST(laws[name]["loss"] > 1e-4);
  const auto given = Json::parse(mariotte("law thrown_rod.toml --rivals --restitution 0.5 --json").out);
  for (const auto& law : given["laws"])
    BOOST_TEST((law["name"] == "simulation" ? law["restitution"].is_null() : law["restitution"] == 0.5));
  BOOST_TEST(has(mariotte("law thrown_rod.toml").out, "T⁺/T⁻"));
  BOOST_TEST(mariotte("law thrown_rod.toml --energy-ratio 0.9").code == 2);
  BOOST_TEST(mariotte("law thrown_rod.toml --rivals --restitution -1").code == 3);
  const auto flat = mariotte(
      "law thrown_rod.toml --set 'bodies.body[0].angle=0' --set 'bodies.body[0].position=[0, \"5.1 mm\"]'");
  BOOST_TEST(flat.code == 3);
  BOOST_TEST(has(flat.err, "floor–rod.1 and floor–rod.2 are closed together"));
}

BOOST_FIXTURE_TEST_CASE(flags_without_sense_give_code_2, Session) {
  for (const std::string arguments :
       {"law", "law --mass 1,1", "law --mass 1,1 --velocity 1,0 --energy-ratio 1",
        "law --mass 1,1 --velocity 1,0 --direction 1",
        "law --mass 1,x --velocity 1,0 --direction 1 --energy-ratio 1",
        "law --mass 1,1 --velocity 1,0 --direction 1 --energy-ratio=-1",
        "law --mass 1,-1 --velocity 1,0 --direction 1 --energy-ratio 1",
        "law --mass 1,1 --velocity 1,0,0 --direction 1 --energy-ratio 1",
        "law --mass 1,1 --velocity 1,0 --icr 1 --direction 1 --energy-ratio 1",
        "law --mass 1,1 --velocity 1,0 --direction 1 --energy-ratio 1 --frame lab"})
    BOOST_TEST(support::is_refused(mariotte(arguments)), arguments);
  const auto ratios = mariotte("law --mass 1,1,1 --velocity 1,0,0 --icr 1.5,2 --energy-ratio 1");
  BOOST_TEST(has(ratios.err, "one value per contact (2), got 3; of ratios there is one less"));
}
