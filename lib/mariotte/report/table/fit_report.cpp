#include "mariotte/report/table/fit_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/core/counted.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

using study::Estimate;
using study::Measurement;

double residual(const FitReport& report, std::size_t row) {
  return report.measurements.rows[row].measured - report.fit.predicted[row].value;
}

double scatter(const study::Fit& fit) {
  return std::sqrt(fit.chi_square / static_cast<double>(fit.degrees_of_freedom));
}

std::string summary(const FitReport& report) {
  const auto& [fit, measurements, title, sha256] = report;
  std::string text = fmt::format("{} of {} · {} · residuals {:.3g}{} (root mean square)\n",
                                 counted(measurements.rows.size(), "measurement"), measurements.file,
                                 counted(fit.estimates.size(), "value"), fit.rms,
                                 measurements.unit == "1" ? "" : " " + measurements.unit);
  if (measurements.weighted)
    text += fmt::format("they scatter {:.3g} times as much as their deviations say (χ² {:.4g}, {})\n",
                        scatter(fit), fit.chi_square,
                        counted(fit.degrees_of_freedom, "degree of freedom", "degrees of freedom"));
  return text +
         fmt::format("{}, {} of them with exact slopes\n", counted(fit.runs, "run"), fit.runs_with_slopes);
}

std::string values(const study::Fit& fit) {
  const auto row = [&](Index i) -> TableRow {
    const auto& [key, start, value, error, lower, upper] = fit.estimates[static_cast<std::size_t>(i)];
    return {key, rounded(start, 6), rounded(value, 8), std::isfinite(error) ? rounded(error, 2) : "–",
            fmt::format("{:.6g} to {:.6g}", lower, upper)};
  };
  return "\nValues [SI]\n" + columns({"key", "start", "value", "standard error",
                                      fmt::format("{:g} % interval", 100 * fit.confidence)},
                                     std::ssize(fit.estimates), row);
}

std::string correlation(const study::Fit& fit) {
  if (fit.estimates.size() < 2) return "";
  TableRow header = {"key"};
  for (std::size_t i = 1; i <= fit.estimates.size(); ++i) header.push_back(std::to_string(i));
  const auto row = [&](Index i) {
    TableRow cells = {fit.estimates[static_cast<std::size_t>(i)].key};
    for (const double one : fit.correlation[static_cast<std::size_t>(i)]) cells.push_back(fixed(one, 3));
    return cells;
  };
  return "\nCorrelation\n" + columns(header, std::ssize(fit.estimates), row);
}

/// As many digits as restitution has, or six.
std::string measured_text(const FitReport& report, double value) {
  return report.measurements.quantity.starts_with("restitution") ? fixed(value, 6) : rounded(value, 6);
}

std::string residuals(const FitReport& report) {
  TableRow header = {"line"};
  for (const auto& setting : report.measurements.settings) header.push_back(setting.name);
  const auto& unit = report.measurements.unit;
  for (const std::string name : {"measured", "predicted", "residual"})
    header.push_back(unit == "1" ? name : name + " [" + unit + "]");
  if (report.measurements.weighted) header.push_back("/ deviation");
  const auto row = [&](Index i) {
    const auto number = static_cast<std::size_t>(i);
    const auto& one = report.measurements.rows[number];
    const auto& predicted = report.fit.predicted[number];
    TableRow cells = {std::to_string(one.place.line)};
    cells.insert(cells.end(), one.written.begin(), one.written.end());
    cells.push_back(measured_text(report, one.measured));
    cells.push_back(predicted.captured ? "captured" : measured_text(report, predicted.value));
    cells.push_back(measured_text(report, residual(report, number)));
    if (report.measurements.weighted) cells.push_back(fixed(residual(report, number) / one.deviation, 2));
    return cells;
  };
  return "\nResiduals\n" + columns(header, std::ssize(report.measurements.rows), row);
}

Json json_of(const Estimate& one) {
  return {{"key", one.key},
          {"start", one.start},
          {"value", one.value},
          {"standard_error", one.standard_error},
          {"interval", {one.lower, one.upper}}};
}

Json json_of_row(const FitReport& report, std::size_t row) {
  const auto& one = report.measurements.rows[row];
  const auto& predicted = report.fit.predicted[row];
  Json settings = Json::object();
  for (std::size_t i = 0; i < one.values.size(); ++i)
    settings[report.measurements.settings[i].key] = json_of_value(one.values[i]);
  return {{"line", one.place.line},
          {"settings", settings},
          {"measured", one.measured},
          {"deviation", report.measurements.weighted ? Json(one.deviation) : Json(nullptr)},
          {"predicted", predicted.value},
          {"residual", residual(report, row)},
          {"captured", predicted.captured}};
}

}  // namespace

std::string table(const FitReport& report) {
  return heading(report.title.empty() ? "Fit to measurements" : report.title) + summary(report) +
         values(report.fit) + correlation(report.fit) + residuals(report);
}

Json json(const FitReport& report) {
  const auto& [fit, measurements, title, sha256] = report;
  Json rows = Json::array();
  for (std::size_t row = 0; row < measurements.rows.size(); ++row) rows.push_back(json_of_row(report, row));
  return {{"title", title},
          {"data", measurements.file},
          {"quantity", measurements.quantity},
          {"estimates", list(fit.estimates, [](const Estimate& one) { return json_of(one); })},
          {"confidence", fit.confidence},
          {"correlation", fit.correlation},
          {"rms", fit.rms},
          {"chi_square", fit.chi_square},
          {"degrees_of_freedom", fit.degrees_of_freedom},
          {"runs", fit.runs},
          {"runs_with_slopes", fit.runs_with_slopes},
          {"warnings", fit.warnings},
          {"measurements", rows},
          {"provenance", provenance_json(sha256)}};
}

std::string points_csv(const FitReport& report, const std::optional<study::FitCurves>& curves) {
  std::string text = "line";
  for (const auto& setting : report.measurements.settings) text += "," + cell(setting.key, setting.unit);
  for (const auto* name : {"measured", "deviation", "predicted", "residual"})
    text += "," + cell(name, report.measurements.unit);
  text += ",captured,curve\n";
  for (std::size_t row = 0; row < report.measurements.rows.size(); ++row) {
    const auto& one = report.measurements.rows[row];
    text += std::to_string(one.place.line);
    for (const auto& value : one.values) append_value(value, text += ',');
    text += fmt::format(
        ",{},{},{},{},{},{}\n", exact(one.measured), report.measurements.weighted ? exact(one.deviation) : "",
        exact(report.fit.predicted[row].value), exact(residual(report, row)),
        report.fit.predicted[row].captured, curves ? std::to_string(curves->curve_of_row[row] + 1) : "");
  }
  return text;
}

}  // namespace mariotte::report
