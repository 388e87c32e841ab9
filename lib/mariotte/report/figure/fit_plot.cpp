#include "mariotte/report/figure/fit_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr const char* fit_figure = "fit";
constexpr const char* residuals_figure = "residuals";

std::string axis_name(const std::string& key) {
  return key == "incidence.normal_speed" ? "incident normal speed v_n [m/s]" : name_of_input(key) + " [SI]";
}

/// Between the ends of the curves, with tics at 1, 2, 3, 5 and 7 of every decade.
std::string logarithmic_axis(const study::FitCurves& curves) {
  double least = INFINITY, most = 0;
  for (const auto& curve : curves.curves)
    for (const double at : curve.abscissa) {
      least = std::min(least, at);
      most = std::max(most, at);
    }
  std::string tics;
  for (double decade = std::pow(10, std::floor(std::log10(least))); decade <= most; decade *= 10)
    for (const double digit : {1, 2, 3, 5, 7})
      tics += fmt::format("{}'{:.3g}' {:.3g}", tics.empty() ? "" : ", ", digit * decade, digit * decade);
  return fmt::format("set logscale x\nset xrange [{:.4g}:{:.4g}]\nset xtics ({})\n", least, most, tics);
}

/// `column` of the rows of one curve in points.csv, whose curve stands in the last column, `last`.
std::string of_curve(std::size_t curve, std::size_t last, std::size_t column) {
  return fmt::format("(${}=={} ? ${} : NaN)", last, curve + 1, column);
}

/// Columns of points.csv, from 1.
struct Places {
  explicit Places(const study::Measurements& measurements) : settings(measurements.settings.size()) {}

  std::size_t settings;
  std::size_t abscissa(const study::FitCurves& curves) const { return curves.setting + 2; }
  std::size_t measured() const { return settings + 2; }
  std::size_t deviation() const { return settings + 3; }
  std::size_t residual() const { return settings + 5; }
  std::size_t curve() const { return settings + 7; }
};

/// The points of one curve, with error bars if there are deviations.
std::string points(const FitReport& report, const study::FitCurves& curves, std::size_t k, std::size_t height,
                   const std::string& title) {
  const Places places(report.measurements);
  const auto bars = report.measurements.weighted ? fmt::format(":(${})", places.deviation()) : std::string();
  return fmt::format("'points.csv' every ::1 using {}:{}{} with {} lt {} dt solid lw 1.5 ps 1.6 {}",
                     places.abscissa(curves), of_curve(k, places.curve(), height), bars,
                     bars.empty() ? "points" : "yerrorbars", k + 1, title);
}

/// Micrometres are written as tables of measurements have them, "um".
std::string title_of(const study::FitCurve& curve) {
  auto name = curve.name.empty() ? "fit" : curve.name;
  if (name.ends_with(" um")) name.replace(name.size() - 2, 1, "µ");
  return fmt::format("title {} noenhanced", quoted(name));
}

/// Restitution wherever it was measured, or a key of a result.
std::string quantity_of(const study::Measurements& measurements) {
  return measurements.quantity.starts_with("restitution") ? "restitution" : measurements.quantity;
}

std::string label_of(const study::Measurements& measurements) {
  const auto quantity = quantity_of(measurements);
  return quantity == "restitution" ? "restitution e" : plain(quantity);
}

std::string measured_plot(const FitReport& report, const study::FitCurves& curves) {
  std::vector<std::string> draw;
  for (std::size_t k = 0; k < curves.curves.size(); ++k) {
    draw.push_back(fmt::format("'curves.csv' skip 1 using 2:($1=={} ? $3 : NaN) with lines lt {} lw 2 {}",
                               k + 1, k + 1, title_of(curves.curves[k])));
    draw.push_back(points(report, curves, k, Places(report.measurements).measured(), "notitle"));
  }
  return fmt::format("plot {}\n", fmt::join(draw, ", \\\n  "));
}

std::string residual_plot(const FitReport& report, const study::FitCurves& curves) {
  std::vector<std::string> draw = {"0 with lines lc rgb '#555555' notitle"};
  for (std::size_t k = 0; k < curves.curves.size(); ++k)
    draw.push_back(
        points(report, curves, k, Places(report.measurements).residual(), title_of(curves.curves[k])));
  return fmt::format("plot {}\n", fmt::join(draw, ", \\\n  "));
}

}  // namespace

std::string curves_csv(const study::FitCurves& curves, const study::Measurements& measurements) {
  std::string text = "curve," + cell(measurements.settings[curves.setting].key) + "," +
                     cell(quantity_of(measurements)) + "\n";
  for (std::size_t k = 0; k < curves.curves.size(); ++k) {
    const auto& curve = curves.curves[k];
    for (std::size_t i = 0; i < curve.abscissa.size(); ++i)
      text += fmt::format("{}{},{},{}\n", i > 0 && curve.captured[i] != curve.captured[i - 1] ? "\n" : "",
                          k + 1, exact(curve.abscissa[i]), exact(curve.ordinate[i]));
  }
  return text;
}

std::string fit_script(const FitReport& report, const study::FitCurves& curves) {
  const auto key = report.measurements.settings[curves.setting].key;
  const auto head = report.title.empty() ? std::string("Fit") : report.title;
  return script_head() +
         fmt::format("set xlabel {}\n{}", quoted(axis_name(key)),
                     curves.logarithmic ? logarithmic_axis(curves) : "") +
         fmt::format("\nset title {} noenhanced\nset ylabel {}\n", quoted(head),
                     quoted(label_of(report.measurements))) +
         on_all_terminals(fit_figure, measured_plot(report, curves), wide) +
         fmt::format("\nset title {} noenhanced\nset ylabel 'measured − predicted'\n",
                     quoted(head + ": residuals")) +
         on_all_terminals(residuals_figure, residual_plot(report, curves), wide);
}

std::vector<std::string> fit_figures() {
  auto files = files_of_figure(fit_figure);
  for (const auto& file : files_of_figure(residuals_figure)) files.push_back(file);
  return files;
}

}  // namespace mariotte::report
