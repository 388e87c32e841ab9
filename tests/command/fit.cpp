#define BOOST_TEST_MODULE command_fit
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "session.hpp"

using support::has;
using support::Session;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

struct Fits : Session {
  Fits() {
    fs::copy(MARIOTTE_SCENES "/sphere_fit.toml", folder / "spheres.toml");
    fs::copy(MARIOTTE_SCENES "/sphere_fit.csv", folder / "measured.csv");
  }
};

}  // namespace

BOOST_FIXTURE_TEST_CASE(fit_prints_values_with_their_errors, Fits) {
  const auto fit = mariotte("fit spheres.toml measured.csv -q");
  BOOST_TEST(fit.code == 0);
  BOOST_TEST(fit.err == "");
  for (const char* part : {"30 measurements of measured.csv", "surface.zeta_hertz", "standard error",
                           "95 % interval", "Correlation", "Residuals", "28 degrees of freedom"})
    BOOST_TEST(has(fit.out, part), part);
}

BOOST_FIXTURE_TEST_CASE(the_example_gives_its_truth_back_within_the_intervals, Fits) {
  const auto fit = Json::parse(mariotte("fit spheres.toml measured.csv --json").out);
  const double truth[] = {1.5, 0.5};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& one = fit["estimates"][i];
    BOOST_TEST(one["interval"][0].get<double>() < truth[i]);
    BOOST_TEST(one["interval"][1].get<double>() > truth[i]);
    BOOST_TEST(one["start"] == 1.0);
  }
}

BOOST_FIXTURE_TEST_CASE(measurements_are_not_overwritten_by_the_points_of_their_fit, Fits) {
  fs::rename(folder / "measured.csv", folder / "points.csv");
  const auto before = support::content(folder / "points.csv");
  const auto fit = mariotte("fit spheres.toml points.csv --out . --force");
  BOOST_TEST(support::is_refused(fit), fit.err);
  BOOST_TEST(has(fit.err, "DATA and --out are one file, "), fit.err);
  BOOST_TEST(support::content(folder / "points.csv") == before);
}

BOOST_FIXTURE_TEST_CASE(a_wider_confidence_makes_wider_intervals, Fits) {
  const auto width = [&](const std::string& confidence) {
    const auto fit =
        Json::parse(mariotte("fit spheres.toml measured.csv --json --confidence " + confidence).out);
    const auto& interval = fit["estimates"][0]["interval"];
    return interval[1].get<double>() - interval[0].get<double>();
  };
  BOOST_TEST(width("0.99") > 1.2 * width("0.95"));
}

BOOST_FIXTURE_TEST_CASE(what_a_sweep_wrote_can_be_fitted, Fits) {
  fs::copy(MARIOTTE_SCENES "/microsphere.toml", folder);
  const auto text = support::content(folder / "microsphere.toml");
  write("sweep.toml", text + "[[sweep]]\nkey = \"incidence.normal_speed\"\nfrom = 3\nto = 20\ncount = 12\n");
  BOOST_TEST(mariotte("sweep sweep.toml --out swept --column restitution.tip --no-figures").code == 0);
  const auto fit = Json::parse(
      mariotte("fit spheres.toml swept/sweep.csv --json --free surface.zeta_hertz "
               "--free surface.zeta_adhesion,surface.work_of_adhesion --set surface.work_of_adhesion=0.3")
          .out);
  const double truth[] = {1.5, 0.5, 0.38};
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(fit["estimates"][i]["value"].get<double>() / truth[i] - 1) < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(out_holds_the_fit_its_points_and_its_curves, Fits) {
  BOOST_TEST(mariotte("fit spheres.toml measured.csv --out results").code == 0);
  for (const char* name : {"fit.json", "points.csv", "curves.csv", "plot.gp"})
    BOOST_TEST(fs::file_size(folder / "results" / name) > 0, name);
  const auto printed = mariotte("fit spheres.toml measured.csv --json").out;
  BOOST_TEST(support::content(folder / "results/fit.json") == printed);

  const auto again = mariotte("fit spheres.toml measured.csv --out results");
  BOOST_TEST(again.code == 6);
  BOOST_TEST(has(again.err, "fit.json"));
  BOOST_TEST(mariotte("fit spheres.toml measured.csv --out results --force").code == 0);
}

BOOST_FIXTURE_TEST_CASE(captured_where_separation_was_measured_is_a_warning, Fits) {
  write("slow.csv", support::content(folder / "measured.csv") + "4.9,0.5,0.6,10\n");
  const auto fit = mariotte("fit spheres.toml slow.csv");
  BOOST_TEST(fit.code == 0);
  BOOST_TEST(has(fit.err, "1 of 31 measured rebounds is predicted to be a capture"), fit.err);
  BOOST_TEST(mariotte("fit spheres.toml slow.csv --quiet").err == "");
}

BOOST_FIXTURE_TEST_CASE(what_cannot_be_determined_fails_and_writes_nothing, Fits) {
  const auto fit =
      mariotte("fit spheres.toml measured.csv --set surface.friction=0.2 --free surface.friction --out r");
  BOOST_TEST(fit.code == 1);
  BOOST_TEST(has(fit.err, "do not determine surface.friction"));
  BOOST_TEST(!fs::exists(folder / "r/fit.json"));
}

// Its slopes are rounding of runs: a ball of `thornton` loses the same share whatever its radius.
BOOST_FIXTURE_TEST_CASE(a_number_on_which_nothing_depends_is_refused_alone, Fits) {
  write("balls.csv", "speed,restitution\n0.1,0.945\n0.3,0.73\n1,0.545\n3,0.412\n");
  const auto fit = mariotte("fit " MARIOTTE_SCENES "/steel_pair.toml balls.csv --free chain.radius");
  BOOST_TEST(fit.code == 1);
  BOOST_TEST(has(fit.err, "nothing that was measured depends on it"), fit.err);
}

BOOST_FIXTURE_TEST_CASE(a_restitution_that_holds_at_every_speed_is_told, Fits) {
  write("pair.toml",
        "[chain]\nradius = 0.01\nmaterial = 'steel'\nlaw = 'kuwabara-kono'\nballs = 2\n"
        "restitution = 0.8\nvelocity = [0.5, 0]\n");
  write("balls.csv", "speed,restitution\n0.1,0.86\n0.3,0.82\n1,0.77\n3,0.72\n");
  const std::string line = "fit pair.toml balls.csv --free chain.restitution";
  const std::string why =
      "warning: 'chain.restitution' is met at every speed, by another damping at each; 'chain.at'";
  BOOST_TEST(has(mariotte(line).err, why), mariotte(line).err);
  BOOST_TEST(!has(mariotte(line + " --set chain.at=0.5").err, why));
}

BOOST_FIXTURE_TEST_CASE(bad_data_are_refused_by_file_line_and_column, Fits) {
  write("bad.csv", "speed,restitution\n5,0.8\n6,high\n");
  const auto bad = mariotte("fit spheres.toml bad.csv");
  BOOST_TEST(bad.code == 3);
  BOOST_TEST(has(bad.err, "bad.csv:3:3: "), bad.err);
  write("foreign.csv", "speed,contacts[0].peak_force\n5,0.8\n6,0.8\n7,0.8\n");
  const auto foreign = mariotte("fit spheres.toml foreign.csv");
  BOOST_TEST(foreign.code == 3);
  BOOST_TEST(has(foreign.err, "foreign.csv:1:7: no result has 'contacts[0].peak_force'"), foreign.err);
  BOOST_TEST(has(foreign.err, "[W004]"));
  write("few.csv", "speed,restitution\n5,0.8\n6,0.8\n");
  BOOST_TEST(mariotte("fit spheres.toml few.csv").code == 3);
  BOOST_TEST(mariotte("fit spheres.toml missing.csv").code == 6);
  BOOST_TEST(mariotte("fit three.toml measured.csv").code == 2);
  const auto three = mariotte("fit three.toml measured.csv --free chain.stiffness");
  BOOST_TEST(three.code == 3);
  BOOST_TEST(has(three.err, "two balls of a [chain], have a restitution"), three.err);
  BOOST_TEST(mariotte("fit spheres.toml").code == 2);
}
