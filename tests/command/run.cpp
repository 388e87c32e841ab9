#define BOOST_TEST_MODULE command_run
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "long_chain.hpp"
#include "session.hpp"

using support::content;
using support::has;
using support::lines;
using support::Session;
using support::sixty_balls;
using Json = nlohmann::json;
namespace fs = std::filesystem;

BOOST_FIXTURE_TEST_CASE(run_prints_a_table_and_nothing_on_stderr, Session) {
  const auto run = mariotte("run three.toml");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(run.out.starts_with("Three balls\n"));
  BOOST_TEST(has(run.out, "separated at"));
  BOOST_TEST(run.err == "");
  BOOST_TEST(entries() == 1);
}

BOOST_FIXTURE_TEST_CASE(json_is_one_object_alone_on_stdout, Session) {
  const auto run = mariotte("run three.toml --json -v");
  BOOST_TEST(run.code == 0);
  const auto result = Json::parse(run.out);
  BOOST_TEST(result["ending"] == "separated");
  BOOST_TEST(result["final"]["velocity"].size() == 3);
  BOOST_TEST(result["accuracy"]["estimated"].is_null());
  BOOST_TEST(result["provenance"]["version"] == MARIOTTE_VERSION);
}

BOOST_FIXTURE_TEST_CASE(set_accuracy_and_estimate_reach_the_run, Session) {
  const auto run = mariotte(
      "run three.toml --json --set 'chain.velocity[0]=2' --set 'chain.velocity[2]=1' "
      "--accuracy 1e-6 --estimate");
  const auto result = Json::parse(run.out);
  BOOST_TEST(std::abs(result["momentum"]["initial"].get<double>() - 3) < 1e-12);
  BOOST_TEST(result["accuracy"]["requested"] == 1e-6);
  BOOST_TEST(result["accuracy"]["estimated"].get<double>() < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(a_flow_asked_for_is_the_flow_used, Session) {
  const auto flows = Json::parse(mariotte("run three.toml --json --flow cvode-bdf-dense").out)["flows"];
  BOOST_TEST(std::any_of(flows.begin(), flows.end(),
                         [](const Json& flow) { return flow["name"] == "cvode-bdf-dense"; }));
}

BOOST_FIXTURE_TEST_CASE(out_holds_result_events_trace_and_plot, Session) {
  const auto run = mariotte("run three.toml --out a/b");
  BOOST_TEST(run.code == 0);
  for (const char* name : {"result.json", "events.csv", "trace.csv", "plot.csv", "plot.gp"})
    BOOST_TEST(fs::file_size(folder / "a/b" / name) > 0, name);
  const auto result = Json::parse(content(folder / "a/b/result.json"));
  BOOST_TEST(result["title"] == "Three balls");
  BOOST_TEST(content(folder / "a/b/trace.csv").starts_with("time [s],v1 [m/s],v2 [m/s],v3 [m/s],gap1 [m]"));
}

BOOST_FIXTURE_TEST_CASE(a_run_lists_what_it_wrote, Session) {
  const auto run = mariotte("run three.toml --out results --report");
  for (const auto& entry : fs::directory_iterator(folder / "results"))
    BOOST_TEST(has(run.err, entry.path().filename().string()));
  BOOST_TEST(has(run.err, "mariotte: wrote results: "));
}

BOOST_FIXTURE_TEST_CASE(figures_are_drawn_or_their_absence_is_said, Session) {
  const auto run = mariotte("run three.toml --out results");
  const bool drawn = fs::exists(folder / "results/forces.png") && fs::exists(folder / "results/energy.svg");
  BOOST_TEST(drawn == !has(run.err, "no figures"));
}

BOOST_FIXTURE_TEST_CASE(without_gnuplot_data_and_script_are_written_and_said_so, Session) {
  fs::create_directory(folder / "empty");
  const auto run = shell("PATH=\"$PWD/empty\" \"$mariotte\" run three.toml --out results");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.err, "mariotte: warning: no figures: gnuplot is not installed"));
  BOOST_TEST(entries("results") == 7);
}

BOOST_FIXTURE_TEST_CASE(results_are_not_overwritten_unless_forced, Session) {
  mariotte("run three.toml --out results");
  const auto before = content(folder / "results/result.json");
  const auto refused = mariotte("run three.toml --out results --accuracy 1e-6");
  BOOST_TEST(refused.code == 6);
  BOOST_TEST(refused.out == "");
  BOOST_TEST(has(refused.err, "result.json"));
  BOOST_TEST(content(folder / "results/result.json") == before);
  BOOST_TEST(mariotte("run three.toml --out results --accuracy 1e-6 --force").code == 0);
  BOOST_TEST(content(folder / "results/result.json") != before);
}

BOOST_FIXTURE_TEST_CASE(forced_results_leave_alone_what_no_run_has_written, Session) {
  fs::create_directory(folder / "results");
  const auto stays = [&](const std::string& name) {
    write("results/" + name, "mine");
    const auto run = mariotte("run three.toml --out results --force");
    return run.code == 0 && content(folder / "results" / name) == "mine";
  };
  BOOST_TEST(stays("spacetime.csv"));
  BOOST_TEST(stays("notes.txt"));
  BOOST_TEST(stays("spins.svg"));
  const bool drawn = fs::exists(folder / "results/forces.svg");
  BOOST_TEST(drawn == (shell("command -v gnuplot").code == 0));
  BOOST_TEST(mariotte("run three.toml --out results --force --set 'chain.velocity=[0, 0, 0]'").code == 0);
  BOOST_TEST(!fs::exists(folder / "results/forces.svg"));
}

// As on a full disk: no word, and exit code 0.
BOOST_FIXTURE_TEST_CASE(figures_that_gnuplot_leaves_unfinished_are_none, Session) {
  fs::create_directory(folder / "fake");
  write("fake/gnuplot",
        "#!/bin/sh\neval \"$2\"\n"
        "for name in $(sed -n \"s/^set output folder.'\\(.*\\)'/\\1/p\" plot.gp); do : >\"$folder$name\"; "
        "done\n");
  fs::permissions(folder / "fake/gnuplot", fs::perms::owner_all);
  const auto run = shell("PATH=\"$PWD/fake:$PATH\" \"$mariotte\" run three.toml --out results");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.err, "no figures: gnuplot"), run.err);
  BOOST_TEST(!fs::exists(folder / "results/forces.png"));
}

BOOST_FIXTURE_TEST_CASE(figures_are_drawn_without_a_word_in_any_locale, Session) {
  for (const char* locale : {"C", "POSIX", "nowhere"}) {
    const auto run =
        shell(std::string("LC_ALL=") + locale + " \"$mariotte\" run three.toml -q --force --out results");
    BOOST_TEST(run.code == 0);
    BOOST_TEST(!has(run.err, "warning"), run.err);
  }
}

BOOST_FIXTURE_TEST_CASE(two_outputs_of_one_run_are_two_files, Session) {
  for (const std::string trace : {"results/trace.csv", "./results/../results/events.csv", "three.toml.csv"}) {
    fs::copy_file(folder / "three.toml", folder / "three.toml.csv", fs::copy_options::overwrite_existing);
    const auto run = mariotte("run three.toml.csv --out results --force --trace " + trace);
    BOOST_TEST(support::is_refused(run), run.err);
    BOOST_TEST(has(run.err, " and --trace are one file, " + trace + " [U003]"), run.err);
    BOOST_TEST(content(folder / "three.toml.csv") == support::three_balls);
    BOOST_TEST(!fs::exists(folder / "results"));
  }
  BOOST_TEST(mariotte("run three.toml --out results --trace results/wave.csv").code == 0);
}

BOOST_FIXTURE_TEST_CASE(a_limit_gives_code_5_and_keeps_the_partial_result, Session) {
  const auto run = mariotte("run three.toml --json --out results --set run.max_events=1");
  BOOST_TEST(run.code == 5);
  BOOST_TEST(has(run.err, "mariotte: error: "));
  const auto result = Json::parse(run.out);
  BOOST_TEST(result["ending"] == "event_limit");
  BOOST_TEST(!result["message"].get<std::string>().empty());
  BOOST_TEST(content(folder / "results/result.json") == run.out);
  BOOST_TEST(mariotte("run three.toml --set run.max_time=0.5").code == 5);
}

BOOST_FIXTURE_TEST_CASE(a_chain_that_never_meets_is_a_result, Session) {
  const auto run = mariotte("run three.toml --json --out results --set 'chain.velocity[0]=-1'");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(Json::parse(run.out)["events"].empty());
  BOOST_TEST(fs::exists(folder / "results/result.json"));
}

BOOST_FIXTURE_TEST_CASE(a_run_without_a_collision_says_so, Session) {
  write("apart.toml", "[chain]\nmass = [1, 1]\nvelocity = [1, 2]\ngap = 1\nlaw = 'hertz'\nstiffness = 1\n");
  const auto run = mariotte("run apart.toml");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(
      run.err ==
      "mariotte: warning: nothing collides: no contact ever closes faster than a tenth of the accuracy\n");
  BOOST_TEST(mariotte("run apart.toml -q").err == "");
}

BOOST_FIXTURE_TEST_CASE(a_time_limit_is_no_error, Session) {
  const auto run = mariotte("run three.toml --set run.max_time=2");
  BOOST_TEST(run.code == 5);
  BOOST_TEST(run.err == "mariotte: warning: max_time = 2 s was reached before the end\n");
}

BOOST_FIXTURE_TEST_CASE(a_long_run_says_how_far_it_is, Session) {
  write("bounces.toml",
        "[chain]\nmass = 1\nballs = 1\nwall = 'left'\ngap = 0.1\ngravity = 9.81\nlaw = 'hertz'\n"
        "stiffness = 1e9\n[run]\nmax_time = 1e9\nmax_events = 1_000_000_000\n");
  const auto run = shell(
      "\"$mariotte\" run bounces.toml >told.out 2>told.txt & for i in $(seq 3000); do "
      "grep -q ' events$' told.txt && break; sleep 0.1; done; kill -9 $!; cat told.txt >&2");
  BOOST_TEST(has(run.err, "mariotte: at "));
  BOOST_TEST(has(run.err, " events\n"));
}

BOOST_FIXTURE_TEST_CASE(a_pair_prints_the_restitution_it_had, Session) {
  write("drop.toml",
        "[chain]\nmass = 1\nballs = 1\nwall = 'left'\ngap = 0.1\ngravity = 9.81\nlaw = 'viscoelastic'\n"
        "exponent = 1\nstiffness = 1e12\nrestitution = 0.5\n");
  const auto drop = mariotte("run drop.toml").out;
  BOOST_TEST(has(drop, "approach [m/s]                 1.4007141\n"));  // √(2 g h)
  const double e = std::stod(drop.substr(drop.find("restitution ") + 12));
  BOOST_TEST(std::abs(e - 0.5) < 1e-5);  // gravity takes 2e-6 of the speed during the contact
  BOOST_TEST(!has(mariotte("run three.toml").out, "restitution"));

  write("two.toml",
        "[network]\nradius = 0.01\nmass = 1\nlaw = \"viscoelastic\"\nexponent = 1\nstiffness = 1e9\n"
        "restitution = 0.7\n[[network.ball]]\nposition = [0, 0]\nvelocity = [2, 0]\n"
        "[[network.ball]]\nposition = [0.02, 0]\n");
  const auto two = mariotte("run two.toml").out;
  BOOST_TEST(has(two, "approach [m/s]                 2.0000000\n"));
  BOOST_TEST(has(two, "restitution                 0.7000000000\n"));

  write("sphere.toml",
        "[bodies]\ndimension = 2\nradius = 0.01\nmass = 1\nlaw = \"viscoelastic\"\nexponent = 1\n"
        "stiffness = 1e9\nrestitution = 0.7\n[[bodies.body]]\nposition = [0, 0.01]\nvelocity = [1, -2]\n"
        "[[bodies.plane]]\nnormal = [0, 1]\n");
  const auto sphere = mariotte("run sphere.toml").out;
  BOOST_TEST(has(sphere, "approach [m/s]                 2.0000000\n"));
  BOOST_TEST(has(sphere, "restitution                 0.7000000000\n"));
}

BOOST_FIXTURE_TEST_CASE(every_contact_prints_how_fast_its_balls_first_met, Session) {
  write("drop.toml",
        "[chain]\nballs = 2\nmass = 1\nwall = \"left\"\ngap = [0.1, 0.2]\ngravity = 9.81\nlaw = "
        "\"linear\"\nstiffness = 1e9\n[run]\nmax_time = 0.5\n");
  const auto drop = mariotte("run drop.toml");
  BOOST_TEST(has(drop.out, "  meets [m/s]  "));
  BOOST_TEST(has(drop.out, "1.40071"));  // √(2 g 0.1)
  const auto contact = nlohmann::json::parse(mariotte("run drop.toml --json").out)["contacts"][0];
  BOOST_TEST(std::abs(contact["approach_speed"].get<double>() - std::sqrt(2 * 9.81 * 0.1)) < 1e-9);
  BOOST_TEST(contact["separation_speed"].get<double>() > 1.4);
}

BOOST_FIXTURE_TEST_CASE(an_end_that_is_wanted_is_no_limit, Session) {
  const auto run = mariotte("run three.toml --set run.until=2 --out results --report -q");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(run.err == "");
  BOOST_TEST(has(run.out, "time_limit (run.until) at 2.0000000 s"));
  const auto result = Json::parse(content(folder / "results/result.json"));
  BOOST_TEST(result["ending"] == "time_limit");
  BOOST_TEST(result["final"]["time"] == 2.0);
  BOOST_TEST(!result.contains("message"));
}

BOOST_FIXTURE_TEST_CASE(no_zero_of_a_table_or_a_csv_has_a_sign, Session) {
  BOOST_TEST(!has(mariotte("check three.toml --set 'chain.velocity=[1, -0.0, 0]'").out, " -0 "));
  BOOST_TEST(mariotte("run " MARIOTTE_SCENES "/captured_sphere.toml --out out -q").code == 0);
  BOOST_TEST(mariotte("run three.toml --set 'chain.velocity=[1, -0.0, 0]' --trace out/wave.csv").code == 0);
  const auto found = shell("grep -lE '(^|,)-0(,|$)' out/*.csv");
  BOOST_TEST(found.out == "");
}

BOOST_FIXTURE_TEST_CASE(balls_of_a_long_chain_are_an_image, Session) {
  write("sixty.toml", sixty_balls);
  const auto run = mariotte("run sixty.toml --out results");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(content(folder / "results/plot.gp"), "with image"));
  for (const auto* kind : {"pdf", "png", "svg"})
    BOOST_TEST(fs::exists(folder / (std::string("results/velocities.") + kind)) ==
               !has(run.err, "no figures"));
  BOOST_TEST(!fs::exists(folder / "results/spacetime.csv"));
  BOOST_TEST(has(mariotte("run sixty.toml -v").out, "balls at rest or in free flight"));
}

BOOST_FIXTURE_TEST_CASE(waves_of_a_chain_too_long_for_a_trace_are_an_image, Session) {
  write("row.toml", sixty_balls);
  const auto run = mariotte("run row.toml --set chain.balls=1200 --set run.max_time=40 --out results");
  BOOST_TEST(lines(content(folder / "results/spacetime.csv")) > 100u);
  BOOST_TEST(fs::exists(folder / "results/spacetime.png") == !has(run.err, "no figures"));
}

BOOST_FIXTURE_TEST_CASE(demo_needs_no_file, Session) {
  const auto demo = mariotte("demo");
  BOOST_TEST(demo.code == 0);
  BOOST_TEST(has(demo.out, "separated at"));
  BOOST_TEST(has(demo.out, "5 balls"));
  BOOST_TEST(mariotte("demo coin").code == 0);  // it ends where its scene says
}

BOOST_FIXTURE_TEST_CASE(an_empty_value_is_not_no_value, Session) {
  for (const char* arguments :
       {"run three.toml --out ''", "run three.toml --out=", "run three.toml --trace ''",
        "run three.toml --trace w.csv --every ''", "run three.toml --flow ''", "run ''",
        "sweep three.toml --out ''", "law three.toml --energy-ratio ''", "report ''"}) {
    BOOST_TEST(support::is_refused(mariotte(arguments)), arguments);
    BOOST_TEST(entries() == 1);
  }
  BOOST_TEST(has(mariotte("run three.toml --out ''").err, "--out: an empty value names nothing"));
  BOOST_TEST(mariotte("run three.toml --set title=''").code != 2);
}

BOOST_FIXTURE_TEST_CASE(a_scene_without_an_end_is_refused_at_a_limit, Session) {
  if (!fs::exists("/dev/zero")) return;
  const auto run = mariotte("run /dev/zero");
  BOOST_TEST(run.code == 6);
  BOOST_TEST(has(run.err, "/dev/zero: is longer than 256 MiB [F001]"));
}

BOOST_FIXTURE_TEST_CASE(a_title_has_a_limit, Session) {
  const auto titled = [](std::size_t size) {
    return "title = '" + std::string(size, 'x') + "'\n" + std::string(support::three_balls).substr(22);
  };
  write("long.toml", titled(1000));
  BOOST_TEST(mariotte("run long.toml").code == 0);
  write("longer.toml", titled(10'000'000));
  const auto longer = mariotte("run longer.toml");
  BOOST_TEST(longer.code == 3);
  BOOST_TEST(longer.err == "mariotte: error: longer.toml:1:9: title: has more than 1000 bytes [S023]\n");
}

BOOST_FIXTURE_TEST_CASE(a_title_gives_the_terminal_no_commands, Session) {
  const auto scene = std::string(support::three_balls).substr(22);
  write("red.toml", "title = \"\\u001b[31mred\"\n" + scene);
  const auto red = mariotte("run red.toml");
  BOOST_TEST(red.code == 3);
  BOOST_TEST(red.err == "mariotte: error: red.toml:1:9: title: has a control character [S013]\n");
  write("two.toml", "title = \"one\\ntwo\tthree\"\n" + scene);
  BOOST_TEST(mariotte("run two.toml").code == 0);
}

// Results of undamped chains do not depend on how fast they are: they are found, or the scene is refused.
BOOST_FIXTURE_TEST_CASE(no_speed_makes_nulls_with_code_0, Session) {
  const auto reference = Json::parse(mariotte("run three.toml --json").out)["final"]["velocity"];
  int refused = 0;
  for (int decade = -300; decade <= 300; decade += 30) {
    const auto speed = "1e" + std::to_string(decade);
    const auto run = mariotte("run three.toml --json --set chain.velocity[0]=" + speed);
    if (run.code == 3) {
      BOOST_TEST(has(run.err, "--set chain.velocity[0]: "), run.err);
      BOOST_TEST(has(run.err, "[S035]"));
      ++refused;
      continue;
    }
    BOOST_TEST(run.code == 0);
    const auto result = Json::parse(run.out);
    for (std::size_t i = 0; i < 3; ++i)
      BOOST_TEST(std::abs(result["final"]["velocity"][i].get<double>() / std::stod(speed) -
                          reference[i].get<double>()) < 1e-9);
    for (const char* entry : {"initial", "final", "residual"})
      BOOST_TEST(result["energy"][entry].is_number());
  }
  BOOST_TEST(refused >= 10);
  BOOST_TEST(refused <= 12);
}
