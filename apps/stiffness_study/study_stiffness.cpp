#include <fmt/format.h>

#include "study.hpp"

namespace mariotte::stiffness_study {
namespace {

constexpr const char* by_stiffness = "k [N/m^n]";
constexpr const char* by_mass = "m [kg]";

std::vector<std::pair<std::string, ImpactCase>> impacts() {
  return {{"linear triplet, κ = 2", {.law = "linear", .ratio = 2}},
          {"Hertz triplet", {.law = "hertz"}},
          {"linear chain of 21", {.law = "linear", .balls = 21}},
          {"Hertz chain of 21", {.law = "hertz", .balls = 21}}};
}

Series over_stiffness(const std::string& name, ImpactCase one, bool quick) {
  Series series{.study = "stiffness", .name = name, .family = by_stiffness, .points = {}};
  for (const double k : powers(1, 1e30, quick ? 1e15 : 1e3)) {
    one.stiffness = k;
    series.points.push_back({k, one});
  }
  return series;
}

Series over_mass(const std::string& name, ImpactCase one, bool quick) {
  Series series{.study = "stiffness", .name = name, .family = by_mass, .points = {}};
  one.stiffness = 1e9;
  for (const double m : powers(1e-12, 1e12, quick ? 1e12 : 1e6)) {
    one.mass = m;
    series.points.push_back({m, one});
  }
  return series;
}

// Linear and Hertz contacts alike: the dimensionless equations contain neither k nor m.
Statement proposition(const Rows& rows) {
  const auto stiffness = select(rows, [](const Row& row) { return row.family == by_stiffness; });
  const auto mass = select(rows, [](const Row& row) { return row.family == by_mass; });
  return invariance(
      fmt::format("Prop. 2.1, {}, k = {}, m = {}", rows.front().series, range(stiffness), range(mass)),
      stiffness, rows);
}

}  // namespace

Findings stiffness_study(const Settings& settings) {
  Findings findings;
  References references(settings.patience());
  for (const auto& [name, one] : impacts()) {
    const auto soft = sweep(over_stiffness(name, one, settings.quick), settings, references);
    auto rows = soft;
    add(rows, sweep(over_mass(name, one, settings.quick), settings, references));
    if (rows.empty()) continue;
    findings.statements.push_back(proposition(rows));
    findings.statements.push_back(steps_statement(soft, "k"));
    add(findings.rows, rows);
  }
  const auto stiffness = select(findings.rows, [](const Row& row) { return row.family == by_stiffness; });
  findings.figures = figures_by_flow(stiffness, "k [N/m^n]", Figure::Quantity::seconds);
  for (auto& one : error_statements(findings.rows)) findings.statements.push_back(one);
  return findings;
}

}  // namespace mariotte::stiffness_study
