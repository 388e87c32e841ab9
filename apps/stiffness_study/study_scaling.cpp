#include <fmt/format.h>

#include <cmath>

#include "study.hpp"

namespace mariotte::stiffness_study {
namespace {

constexpr const char* along_group = "k, c ∝ k^{n/(n+1)}";
constexpr const char* along_mass = "m, Π and v/m fixed";
constexpr const char* fixed_damping = "k, c fixed";
constexpr const char* fixed_ratio = "k, c ∝ k";
constexpr double base = 0.2;  // damping at k = m = v = 1, as in [Acary 2003, Fig. 4]

Series over_stiffness(const std::string& name, ImpactCase one, const char* family,
                      const std::vector<double>& values, double power) {
  Series series{.study = "scaling", .name = name, .family = family, .points = {}};
  for (const double k : values) {
    one.stiffness = k;
    one.damping = base * std::pow(k, power);
    series.points.push_back({k, one});
  }
  return series;
}

Series over_mass(const std::string& name, ImpactCase one, const std::vector<double>& values) {
  Series series{.study = "scaling", .name = name, .family = along_mass, .points = {}};
  for (const double m : values) {
    one.mass = one.speed = m;
    one.damping = 1;
    one.damping = base / damping_group(one);
    series.points.push_back({m, one});
  }
  return series;
}

std::vector<Series> families(const std::string& name, const ImpactCase& one, bool quick) {
  const double n = exponent(one);
  const auto wide = powers(1, 1e30, quick ? 1e15 : 1e3);
  // Beyond, c ∝ k is plastic impact to every digit, and harder for each decade of k.
  const auto narrow = powers(1, 1e6, quick ? 1e3 : 10);
  return {over_stiffness(name, one, along_group, wide, n / (n + 1)),
          over_mass(name, one, powers(1e-6, 1e6, quick ? 1e6 : 1e3)),
          over_stiffness(name, one, fixed_damping, wide, 0),
          over_stiffness(name, one, fixed_ratio, narrow, 1)};
}

Statement group_decides(const Rows& rows) {
  const auto stiffness = select(rows, [](const Row& row) { return row.family == along_group; });
  const auto mass = select(rows, [](const Row& row) { return row.family == along_mass; });
  auto same = stiffness;
  add(same, mass);
  return invariance(fmt::format("{}, Π = {:g} fixed, k = {}, m = v = {}", rows.front().series, base,
                                range(stiffness), range(mass)),
                    stiffness, same);
}

// Along any other line the ICR must move by much more than any error.
Statement nothing_else_does(const Rows& rows, const char* family) {
  const auto along = select(rows, [&](const Row& row) { return row.family == family; });
  const auto found = spread(along);
  constexpr double visible = 1e-2;
  double last = 0;
  for (const auto& row : along)
    if (row.run.separated() && !row.run.icr.empty()) last = row.run.icr[0].value_or(0);
  return {Statement::Kind::theorem,
          fmt::format("{}: along {} = {} ICRs are not constant, they move by {:.3g} (α₁ ends at {:.10f})",
                      rows.front().series, family, range(along), found.icr, last),
          found.icr > visible};
}

}  // namespace

Findings scaling_study(const Settings& settings) {
  const std::vector<std::pair<std::string, ImpactCase>> impacts = {
      {"damped triplet, n = 3/2", {.law = "viscoelastic", .exponent = 1.5}},
      {"damped triplet, n = 1", {.law = "viscoelastic", .exponent = 1}},
      {"damped chain of 21, n = 3/2", {.law = "viscoelastic", .balls = 21, .exponent = 1.5}}};
  Findings findings;
  References references(settings.patience());
  for (const auto& [name, one] : impacts) {
    Rows rows;
    for (const auto& series : families(name, one, settings.quick))
      add(rows, sweep(series, settings, references));
    if (rows.empty()) continue;
    findings.statements.push_back(group_decides(rows));
    findings.statements.push_back(nothing_else_does(rows, fixed_damping));
    findings.statements.push_back(nothing_else_does(rows, fixed_ratio));
    auto curves = select(
        rows, [&](const Row& row) { return row.flow == rows.front().flow && row.family != along_mass; });
    findings.figures.push_back({"scaling_icr_" + std::to_string(findings.figures.size() + 1), name,
                                "k [N/m^n]", Figure::Quantity::first_icr, &Row::family, std::move(curves)});
    add(findings.rows, rows);
  }
  for (auto& one : error_statements(findings.rows)) findings.statements.push_back(one);
  return findings;
}

}  // namespace mariotte::stiffness_study
