#include "mariotte/report/figure/fit_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/line_names.hpp"
#include "mariotte/report/figure/ticks.hpp"
#include "mariotte/report/figure/title.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr double letters_below = 44;  // along the axis
constexpr const char* fit_figure = "fit";
constexpr const char* residuals_figure = "residuals";

bool is_angle(const study::Setting& setting) {
  return setting.unit == "rad";
}

/// A column of the abscissa as it is shown.
std::string shown(const FitReport& report, const study::FitCurves& curves, std::size_t column) {
  const bool in_degrees = is_angle(report.measurements.settings[curves.setting]);
  return fmt::format("({}${})", in_degrees ? "180/pi*" : "", column);
}

/// Between the ends of the curves.
std::string logarithmic_axis(const study::FitCurves& curves) {
  double least = INFINITY, most = 0;
  for (const auto& curve : curves.curves)
    for (const double at : curve.abscissa) {
      least = std::min(least, at);
      most = std::max(most, at);
    }
  std::string tics;
  for (const double at : logarithmic_ticks(least, most, letters_below))
    tics += fmt::format("{}'{:.3g}' {:.3g}", tics.empty() ? "" : ", ", at, at);
  return fmt::format("set logscale x\nset xrange [{:.4g}:{:.4g}]\nset xtics ({})\n", least, most, tics);
}

/// `column` of the rows of one curve in points.csv, whose curve stands in the last column, `last`.
std::string of_curve(std::size_t curve, std::size_t last, std::size_t column) {
  return fmt::format("(${}=={} ? ${} : NaN)", last, curve + 1, column);
}

/// Columns of points.csv, from 1.
struct ColumnPlaces {
  explicit ColumnPlaces(const study::Measurements& measurements) : settings(measurements.settings.size()) {}

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
  const ColumnPlaces places(report.measurements);
  const auto bars = report.measurements.weighted ? fmt::format(":(${})", places.deviation()) : std::string();
  return fmt::format("'points.csv' every ::1 using {}:{}{} with {} lt {} dt solid lw 1.5 ps 1.6 {}",
                     shown(report, curves, places.abscissa(curves)), of_curve(k, places.curve(), height),
                     bars, bars.empty() ? "points" : "yerrorbars", k + 1, title);
}

/// Restitution wherever it was measured, or a key of a result.
std::string quantity_of(const study::Measurements& measurements) {
  return measurements.quantity.starts_with("restitution") ? "restitution" : measurements.quantity;
}

std::string height_of(std::size_t k) {
  return fmt::format("($1=={} ? $3 : NaN)", k + 1);
}

/// The fitted curves with their names, without a name if there is one.
std::vector<NamedLine> named(const FitReport& report, const study::FitCurves& curves) {
  std::vector<NamedLine> lines;
  if (curves.curves.size() > 1)
    for (std::size_t k = 0; k < curves.curves.size(); ++k)
      lines.push_back(
          {"'curves.csv' skip 1", shown(report, curves, 2), height_of(k), plain(name_of(curves.curves[k]))});
  return lines;
}

/// Sets what `names_beside` asks for.
std::string span(const FitReport& report, const study::FitCurves& curves) {
  double low = INFINITY, high = -INFINITY;
  const auto show = [&](double least, double most) {
    low = std::min(low, least), high = std::max(high, most);
  };
  for (const auto& curve : curves.curves)
    for (const double value : curve.ordinate) show(value, value);
  for (const auto& row : report.measurements.rows) {
    const double bar = report.measurements.weighted ? row.deviation : 0;
    show(row.measured - bar, row.measured + bar);
  }
  return fmt::format("low = {:.9g}; high = {:.9g}; factor = 1; margin = {}\n", low, high, high > low ? 0 : 1);
}

std::string measured_plot(const FitReport& report, const study::FitCurves& curves, bool titled) {
  std::vector<std::string> draw;
  for (std::size_t k = 0; k < curves.curves.size(); ++k) {
    draw.push_back(fmt::format("'curves.csv' skip 1 using {}:{} with lines lt {} lw 2 {}",
                               shown(report, curves, 2), height_of(k), k + 1,
                               titled ? "title " + quoted(plain(name_of(curves.curves[k]))) : "notitle"));
    draw.push_back(points(report, curves, k, ColumnPlaces(report.measurements).measured(), "notitle"));
  }
  return fmt::format(
      "plot {}, \\\n  keyentry with points lc rgb '#555555' pt 7 ps 0.8 title 'measured', \\\n"
      "  keyentry with lines lc rgb '#555555' lw 2 dt solid title 'fitted'\n",
      fmt::join(draw, ", \\\n  "));
}

std::string residual_plot(const FitReport& report, const study::FitCurves& curves) {
  std::vector<std::string> draw = {"0 with lines lc rgb '#555555' notitle"};
  for (std::size_t k = 0; k < curves.curves.size(); ++k)
    draw.push_back(
        points(report, curves, k, ColumnPlaces(report.measurements).residual(),
               curves.curves.size() > 1 ? "title " + quoted(plain(name_of(curves.curves[k]))) : "notitle"));
  return fmt::format("plot {}\n", fmt::join(draw, ", \\\n  "));
}

/// Measurements and curves over the abscissa.
std::string fitted_figure(const FitReport& report, const study::FitCurves& curves) {
  const auto lines = named(report, curves);
  const bool beside = !lines.empty() && fit_beside(lines, "");
  return span(report, curves) + (beside ? names_beside(lines, "") : "") +
         fmt::format("set key below left horizontal height 1\nset ylabel {}\n",
                     quoted(label_of(report.measurements))) +
         (curves.logarithmic ? logarithmic_axis(curves) : "") +
         on_all_terminals(fit_figure, measured_plot(report, curves, !lines.empty() && !beside),
                          sheet_with_names(beside ? 2 : lines.size() + 2));
}

std::string residual_figure(const FitReport& report, const study::FitCurves& curves) {
  return names_below("") + "unset label\nset autoscale y\nset ylabel " +
         quoted(with_unit("measured − predicted", report.measurements.unit)) + "\n" +
         on_all_terminals(residuals_figure, residual_plot(report, curves),
                          sheet_with_names(named(report, curves).size()));
}

}  // namespace

std::string label_of(const study::Setting& setting) {
  return with_unit(name_of_input(setting.key), is_angle(setting) ? "deg" : setting.unit);
}

std::string label_of(const study::Measurements& measurements) {
  const auto is_of_body = [](const study::Setting& one) {
    return one.key.starts_with("incidence.") || one.key.starts_with("body.") ||
           one.key.starts_with("surface.");
  };
  const auto& quantity = measurements.quantity;
  if (quantity == "restitution.centre") return name_of_result(quantity, "e_nm");
  if (quantity_of(measurements) != "restitution")
    return with_unit(name_of_result(quantity, measurements.symbol), measurements.unit);
  const auto& settings = measurements.settings;
  return std::any_of(settings.begin(), settings.end(), is_of_body) ? name_of_result("restitution.tip", "e_n")
                                                                   : "restitution e";
}

std::string name_of(const study::FitCurve& curve) {
  auto name = curve.name;
  if (name.ends_with(" um")) name.replace(name.size() - 2, 1, "µ");
  return name;
}

std::string curves_csv(const study::FitCurves& curves, const study::Measurements& measurements) {
  const auto& setting = measurements.settings[curves.setting];
  std::string text = "curve," + cell(setting.key, setting.unit) + "," +
                     cell(quantity_of(measurements), measurements.unit) + "\n";
  for (std::size_t k = 0; k < curves.curves.size(); ++k) {
    const auto& curve = curves.curves[k];
    for (std::size_t i = 0; i < curve.abscissa.size(); ++i)
      text += fmt::format("{}{},{},{}\n", i > 0 && curve.captured[i] != curve.captured[i - 1] ? "\n" : "",
                          k + 1, exact(curve.abscissa[i]), exact(curve.ordinate[i]));
  }
  return text;
}

std::string fit_script(const FitReport& report, const study::FitCurves& curves) {
  const auto& setting = report.measurements.settings[curves.setting];
  const auto head = report.title.empty() ? std::string("Fit") : report.title;
  return script_head() + fmt::format("set xlabel {}", quoted(label_of(setting))) + set_title(head) +
         fitted_figure(report, curves) + set_title(head + ": residuals") + residual_figure(report, curves);
}

std::vector<std::string> fit_figures() {
  auto files = files_of_figure(fit_figure);
  for (const auto& file : files_of_figure(residuals_figure)) files.push_back(file);
  return files;
}

}  // namespace mariotte::report
