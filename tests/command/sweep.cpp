#define BOOST_TEST_MODULE command_sweep
#include <boost/test/unit_test.hpp>

#include "support/lines.hpp"
#include "sweep_session.hpp"

using support::content;
using support::few;
using support::fields;
using support::has;
using support::lines;
using support::Session;
namespace fs = std::filesystem;

BOOST_FIXTURE_TEST_CASE(a_row_is_what_run_says_of_that_point, Session) {
  write("few.toml", few);
  const auto sweep = mariotte("sweep few.toml --out out --column 'final.velocity[*]' --column 'icr[0]'");
  BOOST_TEST(sweep.code == 0);
  BOOST_TEST(sweep.out == "6 points, all with a result: out/sweep.csv\n");
  const auto rows = lines(content(folder / "out/sweep.csv"));
  BOOST_TEST_REQUIRE(rows.size() == 7);
  BOOST_TEST(rows[0] ==
             "chain.velocity[2] [m/s],chain.mass[1] [kg],final.velocity[0] [m/s],final.velocity[1] [m/s],"
             "final.velocity[2] [m/s],icr[0],"
             "ending,reason");
  const auto run = nlohmann::json::parse(
      mariotte("run few.toml --json --set 'chain.velocity[2]=-0.5' --set 'chain.mass[1]=2'").out);
  const auto cells = fields(rows[2]);
  BOOST_TEST(std::stod(cells[0]) == -0.5);
  BOOST_TEST(std::stod(cells[1]) == 2);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(std::stod(cells[2 + i]) - run["final"]["velocity"][i].get<double>()) < 1e-10);
  BOOST_TEST(std::abs(std::stod(cells[5]) - run["icr"][0].get<double>()) < 1e-8);
  BOOST_TEST(cells[6] == "separated");
}

BOOST_FIXTURE_TEST_CASE(rows_are_written_as_hdf5_if_asked_for, Session) {
  write("few.toml", few);
  const auto sweep = mariotte("sweep few.toml --out out --column 'icr[0]' --hdf5");
  if (has(sweep.err, "built without HDF5")) {
    BOOST_TEST(sweep.code == 6);
    return;
  }
  BOOST_TEST(sweep.code == 0);
  BOOST_TEST(content(folder / "out/sweep.h5").starts_with("\x89HDF"));
  BOOST_TEST(mariotte("sweep few.toml --out out --force").code == 0);
  BOOST_TEST(!fs::exists(folder / "out/sweep.h5"));
}

BOOST_FIXTURE_TEST_CASE(a_body_is_swept_like_a_chain, Session) {
  const std::string body = R"([body]
shape = "sphere"
radius = "2.45 um"
density = "1350 kg/m^3"
[surface]
law = "brach-dunn"
stiffness = "1.74 GPa"
work_of_adhesion = "0.38 J/m^2"
zeta_hertz = 1.5
zeta_adhesion = 0.5
friction = 0.15
[incidence]
normal_speed = "5 m/s"
)";
  const std::string sweep = "[[sweep]]\nkey = 'incidence.normal_speed'\nfrom = '2 m/s'\nto = '6 ";
  write("body.toml", body + sweep + "m/s'\ncount = 5\n");
  const auto done = mariotte("sweep body.toml --out out --no-figures --column restitution.tip");
  BOOST_TEST(done.out == "5 points, all with a result: out/sweep.csv\n");
  const auto run =
      nlohmann::json::parse(mariotte("run body.toml --json --set 'incidence.normal_speed=3'").out);
  const auto row = lines(content(folder / "out/sweep.csv"))[2];
  BOOST_TEST(row.starts_with("3,"));
  // The quick run integrates no balance, so its steps are others; both are right to the accuracy.
  BOOST_TEST(std::abs(std::stod(row.substr(2)) - run["restitution"]["tip"].get<double>()) < 1e-10);
  write("wrong.toml", body + sweep + "m'\ncount = 5\n");
  const auto wrong = mariotte("sweep wrong.toml --out wrong");
  BOOST_TEST(wrong.code == 3);
  BOOST_TEST(has(wrong.err, "wrong.toml:17:6: "));
  BOOST_TEST(has(wrong.err, "expected a velocity"));
}

BOOST_FIXTURE_TEST_CASE(the_last_ball_of_rows_of_any_length_has_a_column, Session) {
  write("rows.toml", R"(columns = ["final.velocity[-1]", "share = final.velocity[-1]^2"]
[chain]
mass = 1
stiffness = 1
law = "hertz"
balls = 2
[[chain.ball]]
number = 1
velocity = 1
[[sweep]]
key = "chain.balls"
values = [2, 5, 3]
)");
  BOOST_TEST(mariotte("sweep rows.toml --out out --no-figures").code == 0);
  const auto rows = lines(content(folder / "out/sweep.csv"));
  BOOST_TEST_REQUIRE(rows.size() == 4);
  BOOST_TEST(rows[0] == "chain.balls,final.velocity[-1] [m/s],share,ending,reason");
  const int balls[] = {2, 5, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto run = nlohmann::json::parse(
        mariotte("run rows.toml --json --set chain.balls=" + std::to_string(balls[i])).out);
    const double last = run["final"]["velocity"].back().get<double>();
    const auto row = fields(rows[i + 1]);
    BOOST_TEST(std::abs(std::stod(row[1]) - last) < 1e-10);
    BOOST_TEST(std::abs(std::stod(row[2]) - last * last) < 1e-10);
  }
  BOOST_TEST(has(mariotte("sweep rows.toml --out out --column ending --force").err,
                 "'ending' is a column of every sweep, and needs no key"));
}

BOOST_FIXTURE_TEST_CASE(a_sweep_is_drawn_unless_it_shall_not, Session) {
  write("few.toml", few);
  const auto drawn = mariotte("sweep few.toml --out out --column 'icr[0]' --column energy.final");
  BOOST_TEST(drawn.code == 0);
  BOOST_TEST(fs::exists(folder / "out/plot.gp"));
  BOOST_TEST(lines(content(folder / "out/plot.csv")).size() == 7);  // a comment, and a point per line
  if (shell("command -v gnuplot").code == 0)
    for (const auto* name : {"icr_0.pdf", "icr_0.png", "icr_0.svg", "energy.final.png", "energy.final.svg"})
      BOOST_TEST(fs::file_size(folder / "out" / (std::string("sweep.") + name)) > 1000);
  const auto again = mariotte("sweep few.toml --out out --column 'icr[0]' --force --no-figures");
  BOOST_TEST(again.code == 0);
  BOOST_TEST(entries("out") == 4);  // sweep.csv, sweep.json, plot.csv, the journal
  const auto missing =
      shell("mkdir -p bin; ln -sf \"$mariotte\" bin/m; PATH=bin m sweep few.toml --out bare");
  BOOST_TEST(missing.code == 0);
  BOOST_TEST(has(missing.err, "gnuplot is not installed; data and script are in bare/plot.gp"));
}

BOOST_FIXTURE_TEST_CASE(a_forced_sweep_removes_what_the_last_one_wrote_and_nothing_else, Session) {
  write("few.toml", few);
  BOOST_TEST(mariotte("sweep few.toml --out out --column 'icr[0]'").code == 0);
  write("out/sweep.icr_0.edited.svg", "mine");
  BOOST_TEST(mariotte("sweep few.toml --out out --column energy.final --force").code == 0);
  BOOST_TEST(content(folder / "out/sweep.icr_0.edited.svg") == "mine");
  BOOST_TEST(!fs::exists(folder / "out/sweep.icr_0.svg"));
  fs::create_directory(folder / "other");
  write("other/report.html", "mine");
  BOOST_TEST(mariotte("sweep few.toml --out other --no-figures --force").code == 0);
  BOOST_TEST(content(folder / "other/report.html") == "mine");
}

BOOST_FIXTURE_TEST_CASE(a_step_that_misses_the_end_of_its_range_warns_once, Session) {
  write("steps.toml", std::string(support::three_balls) +
                          "[[sweep]]\nkey = 'chain.velocity[0]'\nfrom = 1\nto = 2\nstep = 0.3\n");
  const std::string warning =
      "mariotte: warning: steps.toml:13:8: sweep[0].step: does not lead to 'to' in whole steps; the last "
      "value is 1.9\n";
  BOOST_TEST(mariotte("check steps.toml").err == warning);
  BOOST_TEST(mariotte("sweep steps.toml --out out --no-figures").err == warning);
}

BOOST_FIXTURE_TEST_CASE(a_constant_column_does_not_hide_the_numbers_of_the_next, Session) {
  if (shell("command -v gnuplot").code != 0) return;
  write("speeds.toml", std::string(support::three_balls) +
                           "[[sweep]]\nkey = 'chain.velocity[0]'\nfrom = 1\nto = 2\ncount = 5\n");
  // The ratio does not depend on the speed; the energy does.
  BOOST_TEST(mariotte("sweep speeds.toml --out out --column 'icr[0]' --column energy.final").code == 0);
  BOOST_TEST(!has(content(folder / "out/sweep.energy.final.svg"), "no numbers"));
}

BOOST_FIXTURE_TEST_CASE(any_number_of_threads_gives_the_same_csv, Session) {
  write("map.toml", support::map_scene(20));
  for (const std::string threads : {"1", "2", "3"})
    BOOST_TEST(mariotte("sweep map.toml --no-figures --out o" + threads + " --threads " + threads).code == 0);
  const auto one = content(folder / "o1/sweep.csv");
  BOOST_TEST(lines(one).size() == 4001);
  BOOST_TEST((content(folder / "o2/sweep.csv") == one));
  BOOST_TEST((content(folder / "o3/sweep.csv") == one));
}

BOOST_FIXTURE_TEST_CASE(a_random_design_with_expressions_is_the_same_on_any_threads, Session) {
  const std::string sweep =
      "sweep " MARIOTTE_SCENES
      "/scatter.toml --no-figures --column 'gain = final.velocity[2] / chain.velocity[0]'";
  const auto one = mariotte(sweep + " --out one --threads 1"),
             three = mariotte(sweep + " --out three --threads 3");
  BOOST_TEST(has(one.out, "mean   deviation"));
  BOOST_TEST(lines(content(folder / "one/sweep.csv"))[0] ==
             "chain.diameter[1] [m],chain.material.young [Pa],gain,ending,reason");
  for (const char* file : {"sweep.csv", "sweep.json"})
    BOOST_TEST((content(folder / "one" / file) == content(folder / "three" / file)), file);
  const auto statistics = nlohmann::json::parse(content(folder / "one/sweep.json"))["statistics"];
  BOOST_TEST(std::abs(statistics[0]["mean"].get<double>() - 0.01) < 1e-6);  // each part has one value
}

// Nor is it a wall.
BOOST_FIXTURE_TEST_CASE(an_expression_without_a_finite_value_gives_no_mass, Session) {
  write("map.toml", std::string("columns = ['final.time']\n") + support::three_balls +
                        "[[sweep]]\nvariable = 'a'\nvalues = [1, 0]\n[[sweep]]\nkey = 'chain.mass[2]'\n"
                        "expression = '1 / a'\n");
  BOOST_TEST(mariotte("sweep map.toml --no-figures --out out").code == 0);
  const auto rows = lines(content(folder / "out/sweep.csv"));
  BOOST_TEST(has(rows[1], "separated"), rows[1]);
  BOOST_TEST(has(rows[2], "rejected"), rows[2]);
}

BOOST_FIXTURE_TEST_CASE(points_that_fail_are_rows_with_their_reason, Session) {
  write(
      "some.toml",
      std::string(support::three_balls).replace(std::string(support::three_balls).find("gap = 0\n"), 8, "") +
          "[[sweep]]\nkey = 'chain.precompressed'\nvalues = [false, true]\n"
          "[[sweep]]\nkey = 'chain.gap'\nvalues = [0, -0.1]\n");
  const auto sweep = mariotte("sweep some.toml --out out --column final.time");
  BOOST_TEST(sweep.code == 0);
  BOOST_TEST(sweep.out.starts_with("4 points, 1 without a result"));
  const auto rows = lines(content(folder / "out/sweep.csv"));
  BOOST_TEST(rows[2].starts_with("false,-0.10000000000000001,,rejected,"));
  BOOST_TEST(has(rows[2], "must not be negative"));
  const auto none = mariotte("sweep some.toml --out none --set run.flow=nonsense");
  BOOST_TEST(none.code == 3);
  BOOST_TEST(!fs::exists(folder / "none"));
}

BOOST_FIXTURE_TEST_CASE(points_that_end_at_a_limit_are_counted_with_their_reason, Session) {
  const std::string cases =
      std::string(support::three_balls) + "[[sweep]]\nkey = 'run.max_events'\nvalues = [1, 1000]\n";
  write("limited.toml", cases);
  // Side by side, and one by one.
  for (const std::string key : {"'final.velocity[2]'", "'contacts[0].peak_force'"}) {
    const auto sweep = mariotte("sweep limited.toml --out out --force --column " + key);
    BOOST_TEST(sweep.out == "2 points, all with a result, 1 ended at a limit: out/sweep.csv\n");
    const auto rows = lines(content(folder / "out/sweep.csv"));
    BOOST_TEST(rows[1].ends_with(",event_limit,max_events = 1 was reached before the end"), rows[1]);
    BOOST_TEST(rows[2].ends_with(",separated,"), rows[2]);
  }
  write("wanted.toml",
        std::string(support::three_balls) + "[[sweep]]\nkey = 'run.until'\nvalues = [0.1, 0.2]\n");
  BOOST_TEST(mariotte("sweep wanted.toml --out wanted --column final.time").out ==
             "2 points, all with a result: wanted/sweep.csv\n");
}

BOOST_FIXTURE_TEST_CASE(points_beyond_the_limits_of_their_model_are_told_of, Session) {
  write("steel.toml",
        "[chain]\nradius = 0.01\nmaterial = 'steel'\nlaw = 'hertz'\nballs = 2\nvelocity = [0.01, 0]\n"
        "[[sweep]]\nkey = 'chain.velocity[0]'\nfrom = 0.01\nto = 1\ncount = 30\n");
  const auto sweep = mariotte("sweep steel.toml --out out --column final.time");
  BOOST_TEST(sweep.out == "30 points, all with a result: out/sweep.csv\n");
  BOOST_TEST(sweep.err ==
             "mariotte: warning: at 2 of 3 points that were looked at, max p₀/1.6Y is above 1: "
             "the material yields, which the law leaves out, so the rebound is too fast "
             "(--column validity.yield_ratio)\n");
  BOOST_TEST(mariotte("sweep steel.toml --out quiet --column final.time --quiet").err == "");
}

// gnuplot has no range around a single place, and none where nothing is.
BOOST_FIXTURE_TEST_CASE(one_point_and_columns_without_numbers_are_drawn_without_a_word, Session) {
  for (const char* table :
       {"key = 'chain.velocity[0]'\nvalues = [1]\n", "key = 'chain.velocity[0]'\nvalues = [-1, -2]\n",
        "key = 'chain.contact[0].law'\nvalues = ['linear']\n",
        "key = 'chain.velocity[0]'\nfrom = 1\nto = 2\ncount = 1\nscale = 'log'\n"}) {
    write("few.toml", std::string(support::three_balls) + "[[sweep]]\n" + table);
    const auto sweep = mariotte("sweep few.toml --out out --force");
    BOOST_TEST(sweep.code == 0, table);
    BOOST_TEST(sweep.err == "", table);
  }
}

BOOST_FIXTURE_TEST_CASE(points_beyond_double_precision_have_no_result, Session) {
  write("fast.toml", std::string(support::three_balls) +
                         "[[sweep]]\nkey = 'chain.velocity[0]'\nvalues = [1, 1e160, 1e-170, 1e100, 1e308]\n");
  const auto sweep = mariotte("sweep fast.toml --out out --column final.velocity[2]");
  BOOST_TEST(sweep.code == 0);
  BOOST_TEST(sweep.out.starts_with("5 points, 3 without a result"));
  const auto rows = lines(content(folder / "out/sweep.csv"));
  for (const int row : {2, 3, 5}) BOOST_TEST(has(rows[row], ",,rejected,"), rows[row]);
  for (const int row : {2, 3, 5}) BOOST_TEST(has(rows[row], "double precision"), rows[row]);
}

BOOST_FIXTURE_TEST_CASE(a_restitution_that_holds_at_every_speed_is_told, Session) {
  const auto told = [&](const std::string& law) {
    write("pair.toml",
          "[chain]\nradius = 0.01\nmaterial = 'steel'\nballs = 2\nvelocity = [0.5, 0]\nrestitution = 0.8\n" +
              law + "[[sweep]]\nkey = 'chain.velocity[0]'\nvalues = [0.1, 1]\n");
    return has(mariotte("sweep pair.toml --out out --force --no-figures").err,
               "'chain.restitution' is met at every speed");
  };
  BOOST_TEST(told("law = 'kuwabara-kono'\n"));
  BOOST_TEST(!told("law = 'kuwabara-kono'\nat = 0.5\n"));
  BOOST_TEST(!told("law = 'kelvin-voigt'\nstiffness = 1e6\n"));  // one damping has it at all speeds
}

BOOST_FIXTURE_TEST_CASE(formulas_have_names_of_their_own, Session) {
  write("map.toml", support::few);
  const auto run = mariotte("sweep map.toml --out out --column 'final.velocity[0] = icr[0]'");
  BOOST_TEST(run.code == 2);
  BOOST_TEST(has(run.err, "'final.velocity[0]' is the key of a result"), run.err);
}

BOOST_FIXTURE_TEST_CASE(errors_have_their_codes_and_leave_nothing, Session) {
  write("bad.toml",
        std::string(support::three_balls) + "[[sweep]]\nkey = 'chain.velocity[0]'\nvalues = ['1 kg']\n");
  write("few.toml", few);
  const auto bad = mariotte("sweep bad.toml --out out");
  BOOST_TEST(bad.code == 3);
  BOOST_TEST(bad.err.starts_with("mariotte: error: bad.toml:11:11: "));
  BOOST_TEST(mariotte("sweep three.toml --out out").code == 3);
  BOOST_TEST(mariotte("sweep few.toml").code == 2);
  BOOST_TEST(mariotte("sweep few.toml --out out --column icr").code == 2);
  BOOST_TEST(has(mariotte("sweep few.toml --out out --column final.velocty[0]").err,
                 "did you mean 'final.velocity[0]'"));
  const auto word = mariotte("sweep few.toml --out out --column a=chain.contact[0].law");
  BOOST_TEST(has(word.err, "'chain.contact[0].law' is no number that the scene gives ["), word.err);
  BOOST_TEST(mariotte("sweep few.toml --out out --threads 0").code == 2);
  BOOST_TEST(!fs::exists(folder / "out"));
  BOOST_TEST(mariotte("sweep few.toml --out few.toml").code == 6);
  BOOST_TEST(content(folder / "few.toml") == few);
}
