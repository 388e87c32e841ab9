#include "study.hpp"

namespace mariotte::stiffness_study {
namespace {

constexpr const char* by_ratio = "κ";

Series over_ratio(const std::string& name, ImpactCase one, double last, bool quick) {
  Series series{.study = "ratio", .name = name, .family = by_ratio, .points = {}};
  for (const double ratio : powers(1, last, quick ? 100 : 10)) {
    one.ratio = ratio;
    series.points.push_back({ratio, one});
  }
  return series;
}

}  // namespace

Findings ratio_study(const Settings& settings) {
  constexpr double hardest_linear = 1e10, hardest_hertz = 1e6;
  std::vector<Series> all = {over_ratio("linear triplet", {.law = "linear"}, hardest_linear, settings.quick),
                             over_ratio("Hertz triplet", {.law = "hertz"}, hardest_hertz, settings.quick),
                             over_ratio("linear chain of 21, k and κk in turn",
                                        {.law = "linear", .balls = 21}, hardest_linear, settings.quick),
                             over_ratio("Hertz chain of 21, k and κk in turn", {.law = "hertz", .balls = 21},
                                        hardest_hertz, settings.quick)};
  if (settings.quick) all.resize(2);  // the chains take seconds
  Findings findings;
  References references(settings.patience());
  for (const auto& series : all) {
    const auto rows = sweep(series, settings, references);
    if (rows.empty()) continue;
    findings.statements.push_back(times_statement(rows, by_ratio));
    findings.statements.push_back(steps_statement(rows, by_ratio));
    add(findings.rows, rows);
  }
  findings.figures = figures_by_flow(findings.rows, by_ratio, Figure::Quantity::seconds);
  for (auto& one : error_statements(findings.rows)) findings.statements.push_back(one);
  return findings;
}

}  // namespace mariotte::stiffness_study
