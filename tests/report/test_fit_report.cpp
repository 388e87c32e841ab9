#define BOOST_TEST_MODULE report_fit_report
#include <stdlib.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mariotte/report/figure/fit_plot.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/page/files.hpp"
#include "support/measured_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;
namespace fs = std::filesystem;

namespace {

/// A fit of two diameters with noise.
struct Example {
  explicit Example(bool weighted = false) {
    auto measured = noisy(exact(sphere, {"surface.zeta_hertz=1.5", "surface.zeta_adhesion=0.5"},
                                table_of({4.9, 6.89}, speeds(2.5, 20, 8))),
                          0.01, 3);
    measured.weighted = weighted;
    if (weighted)
      for (auto& row : measured.rows) row.deviation = 0.01;
    model.emplace(scene::parse_document(sphere, "scene.toml"), dampings, measured);
    fit = study::fit(*model, dampings);
  }
  report::FitReport report() const {
    return {.fit = fit, .measurements = model->measurements(), .title = "It's a fit", .scene_sha256 = "00"};
  }
  std::optional<study::FitCurves> curves() { return study::fit_curves(*model, fit); }

  std::optional<study::FitModel> model;
  study::Fit fit;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::ptrdiff_t lines(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

/// What is wrong with the figures, or nothing.
std::string problem_of_figures(const report::FitReport& report, const study::FitCurves& curves) {
  std::string folder = (fs::temp_directory_path() / "mariotte-XXXXXX").string();
  ::mkdtemp(folder.data());
  report::write_file(fs::path(folder) / "points.csv", report::points_csv(report, curves));
  report::write_file(fs::path(folder) / "curves.csv", report::curves_csv(curves, report.measurements));
  report::write_file(fs::path(folder) / "plot.gp", report::fit_script(report, curves));
  auto problem = report::draw(folder, report::fit_figures());
  for (const auto& figure : report::fit_figures())
    if (problem.empty() && fs::file_size(fs::path(folder) / figure) < 1000) problem = figure + " is empty";
  fs::remove_all(folder);
  return problem;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_table_shows_values_errors_correlation_and_residuals) {
  const auto text = report::table(Example().report());
  for (const auto* part : {"It's a fit", "16 measurements of data.csv · 2 values", "95 % interval",
                           "surface.zeta_adhesion", "Correlation", "Residuals", "4.9 um"})
    BOOST_TEST(has(text, part), part);
  BOOST_TEST(!has(text, "deviation"));
  BOOST_TEST(has(report::table(Example(true).report()), "14 degrees of freedom"));
}

BOOST_AUTO_TEST_CASE(a_fit_without_a_title_is_one_of_any_scene) {
  const Example example;
  auto report = example.report();
  report.title.clear();
  BOOST_TEST(report::table(report).starts_with("Fit to measurements\n"));
}

BOOST_AUTO_TEST_CASE(json_holds_what_the_fit_found) {
  const Example example;
  const auto json = report::json(example.report());
  BOOST_TEST(json["data"] == "data.csv");
  BOOST_TEST(json["estimates"][0]["key"] == "surface.zeta_hertz");
  BOOST_TEST(json["estimates"][0]["value"] == example.fit.estimates[0].value);
  BOOST_TEST(json["estimates"][1]["interval"][1] == example.fit.estimates[1].upper);
  BOOST_TEST(json["correlation"][0][1] == json["correlation"][1][0]);
  BOOST_TEST(json["degrees_of_freedom"] == 14);
  BOOST_TEST(json["measurements"].size() == 16u);
  const auto& row = json["measurements"][0];
  BOOST_TEST(row["line"] == 2);
  BOOST_TEST(row["settings"]["incidence.normal_speed"] == 2.5);
  BOOST_TEST(row["deviation"].is_null());
  BOOST_TEST(row["residual"].get<double>() == row["measured"].get<double>() - row["predicted"].get<double>());
  BOOST_TEST(json["provenance"]["scene_sha256"] == "00");
}

BOOST_AUTO_TEST_CASE(points_say_to_which_curve_they_belong) {
  Example example;
  const auto text = report::points_csv(example.report(), example.curves());
  BOOST_TEST(text.starts_with(
      "line,body.radius [m],incidence.normal_speed [m/s],measured,deviation,predicted,residual,"
      "captured,curve\n2,"));
  BOOST_TEST(lines(text) == 17);
  BOOST_TEST(has(text, ",false,1\n"));
  BOOST_TEST(text.ends_with(",false,2\n"));
  BOOST_TEST(report::points_csv(example.report(), {}).ends_with(",false,\n"));
}

BOOST_AUTO_TEST_CASE(there_is_a_curve_per_diameter_through_its_measurements) {
  Example example;
  const auto curves = example.curves();
  BOOST_TEST_REQUIRE(curves.has_value());
  BOOST_TEST_REQUIRE(curves->curves.size() == 2u);
  BOOST_TEST(curves->curves[1].name == "diameter 6.89 um");
  BOOST_TEST(curves->logarithmic);
  for (const auto& curve : curves->curves) {
    BOOST_TEST(curve.abscissa.front() < 2.5);
    BOOST_TEST(curve.abscissa.back() > 20);
    BOOST_TEST(std::is_sorted(curve.abscissa.begin(), curve.abscissa.end()));
  }
  const auto& first = curves->curves[0];
  const auto next =
      std::upper_bound(first.abscissa.begin(), first.abscissa.end(), 2.5) - first.abscissa.begin();
  const double e = example.fit.predicted[0].value;
  BOOST_TEST(first.ordinate[static_cast<std::size_t>(next) - 1] <= e);
  BOOST_TEST(first.ordinate[static_cast<std::size_t>(next)] >= e);
}

BOOST_AUTO_TEST_CASE(no_curve_joins_captured_to_separated) {
  Example example;
  study::FitCurves curves;
  curves.curves = {{"", {1, 2, 3}, {0, 0.5, 0.75}, {true, false, false}}};
  BOOST_TEST(has(report::curves_csv(curves, example.report().measurements), "1,1,0\n\n1,2,0.5\n1,3,0.75\n"));
}

BOOST_AUTO_TEST_CASE(figures_say_what_was_measured_and_name_curves_if_there_are_several) {
  Example example;
  auto curves = *example.curves();
  const auto several = report::fit_script(example.report(), curves);
  for (const char* part :
       {"set ylabel 'tip restitution e_n'", "set xlabel 'incident normal speed v_n\u00a0[m/s]'",
        "title 'measured'", "set label 'diameter 6.89 µm' at graph", "pdfcairo size 8.60cm,"})
    BOOST_TEST(has(several, part), part);
  curves.curves.resize(1);
  curves.curves[0].name.clear();
  const auto single = report::fit_script(example.report(), curves);
  BOOST_TEST(has(single, "title 'fitted'"));
  BOOST_TEST(!has(single, "front textcolor"));
  BOOST_TEST(!has(single.substr(single.find("residuals.png")), " title "));
}

BOOST_AUTO_TEST_CASE(many_curves_are_not_drawn) {
  std::vector<double> diameters;
  for (int i = 0; i < 9; ++i) diameters.push_back(4 + 0.1 * i);
  const auto measured = exact(sphere, {}, table_of(diameters, {5, 10}));
  study::FitModel model(scene::parse_document(sphere, "scene.toml"), dampings, measured);
  BOOST_TEST(!study::fit_curves(model, study::fit(model, dampings)).has_value());
}

BOOST_AUTO_TEST_CASE(gnuplot_draws_the_figures) {
  for (const bool weighted : {false, true}) {
    Example example(weighted);
    const auto problem = problem_of_figures(example.report(), *example.curves());
    BOOST_TEST((problem.empty() || problem == "gnuplot is not installed"), problem);
  }
}

BOOST_AUTO_TEST_CASE(all_that_is_no_pure_number_has_its_unit) {
  const std::string scene = R"([chain]
mass = [1, 1]
velocity = [1, 0]
law = "hertz"
stiffness = 1e6
)";
  const auto measured =
      study::parse_measurements("speed,contacts[0].peak_force\n1,250\n2,570\n3,930\n", "data.csv");
  study::FitModel model(scene::parse_document(scene, "scene.toml"), {"chain.stiffness"}, measured);
  const auto fit = study::fit(model, {"chain.stiffness"});
  const report::FitReport report{
      .fit = fit, .measurements = model.measurements(), .title = "", .scene_sha256 = ""};
  const auto curves = study::fit_curves(model, fit);
  BOOST_TEST(report::points_csv(report, curves)
                 .starts_with(
                     "line,chain.velocity[0] [m/s],measured [N],deviation [N],predicted [N],residual [N],"));
  BOOST_TEST(report::curves_csv(*curves, report.measurements)
                 .starts_with("curve,chain.velocity[0] [m/s],contacts[0].peak_force [N]\n"));
  const auto script = report::fit_script(report, *curves);
  for (const char* part : {"set ylabel 'peak force max f_{1}\u00a0[N]'", "v_{1}^{−}\u00a0[m/s]'",
                           "set ylabel 'measured − predicted\u00a0[N]'"})
    BOOST_TEST(has(script, part), part);
}

BOOST_AUTO_TEST_CASE(angles_are_shown_in_degrees_on_an_even_axis) {
  const auto scene = rod + "[run]\nimpacts = 1\n";
  const std::vector<std::string> free = {"surface.zeta_hertz"};
  const auto measured = exact(scene, {"surface.zeta_hertz=1.2"},
                              "incidence.angles[1] [deg],restitution\n5,0\n10,0\n30,0\n60,0\n");
  study::FitModel model(scene::parse_document(scene, "scene.toml"), free, measured);
  const auto fit = study::fit(model, free);
  const auto curves = study::fit_curves(model, fit);
  BOOST_TEST_REQUIRE(curves.has_value());
  BOOST_TEST(!curves->logarithmic);
  const report::FitReport report{
      .fit = fit, .measurements = model.measurements(), .title = "Rod", .scene_sha256 = ""};
  const auto script = report::fit_script(report, *curves);
  for (const char* part :
       {"[deg]", "'curves.csv' skip 1 using (180/pi*$2):", "'points.csv' every ::1 using (180/pi*$"})
    BOOST_TEST(has(script, part), script);
}
