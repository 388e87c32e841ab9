#define BOOST_TEST_MODULE command_body
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "session.hpp"

using support::has;
using support::Session;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

struct Bodies : Session {
  Bodies() {
    fs::copy(MARIOTTE_SCENES "/microsphere.toml", folder);
    fs::copy(MARIOTTE_SCENES "/microrod.toml", folder);
    fs::copy(MARIOTTE_SCENES "/captured_sphere.toml", folder);
  }
  Json json(const std::string& arguments) const { return Json::parse(mariotte(arguments + " --json").out); }
};

}  // namespace

BOOST_FIXTURE_TEST_CASE(run_shows_what_the_tips_do, Bodies) {
  const auto run = mariotte("run microrod.toml -v");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.err, "warning: tip 1: max a/R = 0.238 is above 0.1"));
  BOOST_TEST(mariotte("run microrod.toml -q").err == "");
  for (const char* part : {"separated at", "2 impacts", "tip 1 touches", "is pushed", "slips", "separates",
                           "Restitution", "by friction", "in closed form"})
    BOOST_TEST(has(run.out, part), part);
}

BOOST_FIXTURE_TEST_CASE(who_wants_the_restitution_of_a_body_is_told_the_way, Bodies) {
  const auto run = mariotte("restitution microsphere.toml --from 1 --to 2");
  BOOST_TEST(run.code == 3);
  BOOST_TEST(has(run.err, "for a [body], sweep 'incidence.normal_speed'"));
}

BOOST_FIXTURE_TEST_CASE(what_cannot_be_captured_is_told_what_can, Bodies) {
  const auto run = mariotte("capture " MARIOTTE_SCENES "/newton_cradle_5.toml");
  BOOST_TEST(run.code == 3);
  BOOST_TEST(has(run.err, "only a [body], or two bodies of a [chain], can be captured"));
}

BOOST_FIXTURE_TEST_CASE(json_of_a_body_has_the_promised_keys, Bodies) {
  const auto result = json("run microrod.toml");
  BOOST_TEST(result["model"] == "microbody");
  for (const char* key : {"time", "position", "quaternion", "velocity", "spin"})
    BOOST_TEST(result["final"].contains(key), key);
  BOOST_TEST(std::abs(result["restitution"]["tip"].get<double>() - 0.9456351428) < 1e-9);
  BOOST_TEST(std::abs(result["restitution"]["centre"].get<double>() - 0.0674207118) < 1e-9);
  BOOST_TEST(result["impacts"].size() == 2);
  BOOST_TEST(result["impacts"][1]["tip"] == 2);
  for (const char* key : {"start", "end", "normal_velocity_in", "normal_velocity_out", "peak_force"})
    BOOST_TEST(result["impacts"][0].contains(key), key);
  BOOST_TEST(result["events"][1]["force_sign"] == Json::array({1}));
  for (const char* key : {"hertz_damping", "adhesion_damping", "friction", "residual"})
    BOOST_TEST(result["energy"].contains(key), key);
}

BOOST_FIXTURE_TEST_CASE(a_rod_that_turns_in_the_plane_keeps_two_angles_at_zero, Bodies) {
  // It starts at 42 degrees and turns on beyond 90.
  BOOST_TEST(has(mariotte("run microrod.toml").out, "beta [deg]  42.00000000  146.85377335"));
  const auto final = json("run microrod.toml")["final"];
  BOOST_TEST(std::abs(final["angles"][0].get<double>()) < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(a_captured_body_is_an_end_like_any_other, Bodies) {
  const auto run = mariotte("run captured_sphere.toml");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.out, "captured at"));
  const auto result = json("run captured_sphere.toml");
  BOOST_TEST(result["ending"] == "captured");
  BOOST_TEST(result["restitution"]["tip"] == 0.0);
  BOOST_TEST(result["rest"]["indentation"].get<double>() > 0);
  BOOST_TEST(result["events"].back()["capture"] == Json::array({1}));
}

BOOST_FIXTURE_TEST_CASE(out_holds_result_events_trace_and_plot_of_a_body, Bodies) {
  BOOST_TEST(mariotte("run microrod.toml --out results").code == 0);
  for (const char* name : {"result.json", "events.csv", "trace.csv", "plot.csv", "plot.gp"})
    BOOST_TEST(fs::file_size(folder / "results" / name) > 0, name);
  const auto events = support::content(folder / "results/events.csv");
  BOOST_TEST(events.starts_with("time [s],open,close,stick,slip,force_sign,capture\n0,,1,,1,,\n"));
  BOOST_TEST(support::content(folder / "results/trace.csv")
                 .starts_with("time [s],height [m],x2 [m],x3 [m],v1 [m/s]"));
}

BOOST_FIXTURE_TEST_CASE(angles_friction_and_flow_can_be_set, Bodies) {
  const auto steep = json("run microrod.toml --set 'incidence.angles[1]=60 deg' --set surface.friction=0.7");
  BOOST_TEST(std::abs(steep["restitution"]["centre"].get<double>()) < 0.2);
  const auto cvode = json("run microsphere.toml --flow cvode-adams --accuracy 1e-9");
  BOOST_TEST(cvode["flows"][0]["name"] == "cvode-adams");
  BOOST_TEST(std::abs(cvode["restitution"]["tip"].get<double>() - 0.866282538126) < 1e-8);
}

BOOST_FIXTURE_TEST_CASE(a_time_limit_keeps_the_partial_result, Bodies) {
  const auto run = mariotte("run microsphere.toml --json --set 'run.max_time=10 ns'");
  BOOST_TEST(run.code == 5);
  const auto result = Json::parse(run.out);
  BOOST_TEST(result["ending"] == "time_limit");
  BOOST_TEST(result["impacts"][0]["end"].is_null());
}

BOOST_FIXTURE_TEST_CASE(estimate_measures_the_error_of_a_body, Bodies) {
  const double error = json("run microrod.toml --estimate --accuracy 1e-8")["accuracy"]["estimated"];
  BOOST_TEST(error > 0);
  BOOST_TEST(error < 1e-8);
}

BOOST_FIXTURE_TEST_CASE(check_shows_a_body_in_si, Bodies) {
  const auto scene = json("check microrod.toml");
  BOOST_TEST(scene["model"] == "microbody");
  BOOST_TEST(scene["incidence"]["velocity"] == Json::array({-5.0, 0.0, 0.0}));
  BOOST_TEST(has(mariotte("check microrod.toml").out, "moments of inertia"));
}

BOOST_FIXTURE_TEST_CASE(capture_finds_the_speed_below_which_a_body_stays, Bodies) {
  const double speed = json("capture captured_sphere.toml")["capture_velocity"];
  BOOST_TEST(std::abs(speed - 1.81857741) < 1e-7);
  BOOST_TEST(has(mariotte("capture captured_sphere.toml --tolerance 1e-3").out, "capture velocity 1.8"));
  const auto stopped = mariotte("capture captured_sphere.toml --set run.until='1 ns'");
  BOOST_TEST(stopped.code == 4);
  BOOST_TEST(has(stopped.err, "a run ended with time_limit: until = 1e-09 s was reached before the end"));
  const auto elastic =
      mariotte("capture captured_sphere.toml --set surface.zeta_hertz=0 --set surface.zeta_adhesion=0");
  BOOST_TEST(elastic.code == 1);
  BOOST_TEST(has(elastic.err, "no capture velocity"));
}

BOOST_FIXTURE_TEST_CASE(a_sweep_gives_the_curve_of_restitution_over_tilt, Bodies) {
  fs::copy(MARIOTTE_SCENES "/rod_tilt.toml", folder);
  BOOST_TEST(mariotte("sweep rod_tilt.toml --out tilt --no-figures").code == 0);
  const auto rows = support::content(folder / "tilt/sweep.csv");
  // friction 0.15 at 42 degrees, and one row per point behind the header
  BOOST_TEST(has(rows, "0.067420711"));
  BOOST_TEST(std::count(rows.begin(), rows.end(), '\n') >= 3 * 91 + 1);
}

BOOST_FIXTURE_TEST_CASE(commands_for_another_model_refuse_the_scene, Bodies) {
  const auto law = mariotte("law microrod.toml");
  BOOST_TEST(law.code == 3);
  BOOST_TEST(has(law.err, "need a [chain], [network] or [bodies]"));
  const auto capture = mariotte("capture three.toml");
  BOOST_TEST(capture.code == 3);
  BOOST_TEST(has(capture.err, "only a [body], or two bodies of a [chain]"));
}
