#include "study.hpp"

namespace mariotte::stiffness_study {
namespace {

constexpr const char* by_damping = "c";

// The small ones are those for which reference numbers are stored.
std::vector<double> dampings(double last, bool quick) {
  if (quick) return {0, 1, 10, 1e3, last};
  std::vector<double> values = {0, 0.01, 0.05, 0.1, 0.2, 0.5, 1, 2, 5};
  for (const double c : powers(10, last, 10)) values.push_back(c);
  return values;
}

Series over_damping(const std::string& name, ImpactCase one, double last, bool quick) {
  Series series{.study = "damping", .name = name, .family = by_damping, .points = {}};
  for (const double c : dampings(last, quick)) {
    one.damping = c;
    series.points.push_back({c, one});
  }
  return series;
}

}  // namespace

Findings damping_study(const Settings& settings) {
  const auto damped = [](Index balls, double exponent) {
    return ImpactCase{.law = "viscoelastic", .balls = balls, .exponent = exponent};
  };
  const std::vector<Series> all = {
      over_damping("damped triplet, n = 3/2", damped(3, 1.5), 1e6, settings.quick),
      over_damping("damped triplet, n = 1", damped(3, 1), 1e6, settings.quick),
      over_damping("damped chain of 21, n = 3/2", damped(21, 1.5), 1e4, settings.quick),
      over_damping("damped chain of 21, n = 1", damped(21, 1), 1e4, settings.quick)};
  Findings findings;
  References references(settings.patience());
  for (const auto& series : all) {
    const auto rows = sweep(series, settings, references);
    if (rows.empty()) continue;
    const auto strong = select(rows, [](const Row& row) { return row.value >= 10; });
    findings.statements.push_back(times_statement(strong, by_damping));
    findings.statements.push_back(steps_statement(strong, by_damping));
    add(findings.rows, rows);
  }
  findings.figures = figures_by_flow(findings.rows, "c, with k = m = v = 1", Figure::Quantity::seconds);
  for (auto& one : error_statements(findings.rows)) findings.statements.push_back(one);
  return findings;
}

}  // namespace mariotte::stiffness_study
