#include <fmt/format.h>

#include <cmath>

#include "study.hpp"

namespace mariotte::stiffness_study {
namespace {

const char* exponent_name(double exponent) {
  return exponent == 1 ? "n = 1" : "n = 3/2";
}

std::vector<Series> over_size(bool quick) {
  std::vector<Series> all;
  for (const double exponent : {1.5, 1.0}) {
    Series series{.study = "crossover",
                  .name = fmt::format("matrices, {}, damping ratio 20", exponent_name(exponent)),
                  .family = "balls",
                  .points = {},
                  .longest = 1,
                  .brief = true};
    for (const Index balls : {3, 4, 5, 6, 7, 8, 10, 15, 20, 30, 50, 100, 200, 500, 1000, 2000})
      if (!quick || balls <= 10)
        series.points.push_back({static_cast<double>(balls),
                                 {.law = "viscoelastic",
                                  .balls = balls,
                                  .damping = damping_for(20, exponent),
                                  .exponent = exponent}});
    all.push_back(series);
  }
  return all;
}

std::vector<Series> over_damping_ratio(double accuracy, bool quick) {
  std::vector<Series> all;
  for (const Index balls : {3, 21})
    for (const double exponent : {1.5, 1.0}) {
      Series series{.study = "crossover",
                    .name = fmt::format("stiff or not, {} balls, {}, accuracy {:.0e}", balls,
                                        exponent_name(exponent), accuracy),
                    .family = "c/√(k m*)",
                    .points = {}};
      for (const double ratio : powers(0.1, 1e4, quick ? 100 : std::sqrt(10)))
        series.points.push_back({ratio,
                                 {.law = "viscoelastic",
                                  .balls = balls,
                                  .damping = damping_for(ratio, exponent),
                                  .exponent = exponent}});
      all.push_back(series);
    }
  return all;
}

Series over_linear_chains(double accuracy, bool quick) {
  Series series{.study = "crossover",
                .name = fmt::format("linear chains, accuracy {:.0e}", accuracy),
                .family = "balls",
                .points = {}};
  for (const Index balls : {3, 4, 5, 6, 8, 10, 12, 15, 18, 21, 25, 30, 40, 60})
    if (!quick || balls <= 10)
      series.points.push_back({static_cast<double>(balls), {.law = "linear", .balls = balls}});
  return series;
}

std::vector<Series> over_stiffness_ratio(bool quick) {
  std::vector<Series> all;
  for (const Index balls : {3, 4, 6, 10}) {
    Series series{.study = "crossover",
                  .name = fmt::format("linear chain of {}, k and κk in turn", balls),
                  .family = "κ",
                  .points = {}};
    for (const double ratio : powers(1, 1e8, quick ? 1e4 : 10))
      series.points.push_back({ratio, {.law = "linear", .balls = balls, .ratio = ratio}});
    all.push_back(series);
  }
  return all;
}

}  // namespace

Findings crossover_study(const Settings& settings) {
  Findings findings;
  References references(settings.patience());
  using Flows = std::vector<std::string>;
  const auto run = [&](const Series& series, const Flows& flows, const Settings& with,
                       const std::vector<std::pair<std::string, std::string>>& rivals) {
    const auto rows = sweep(series, flows, with, references);
    for (const auto& [a, b] : rivals) findings.statements.push_back(comparison(rows, a, b));
    add(findings.rows, rows);
  };
  const std::string dense = "cvode-bdf-dense", band = "cvode-bdf-band", klu = "cvode-bdf-klu",
                    adams = "cvode-adams";
  auto loose = settings;  // what a matrix costs does not depend on the number of steps
  loose.accuracy = 1e-6;
  for (const auto& series : over_size(settings.quick))
    run(series, {dense, band, klu}, loose, {{dense, band}, {band, klu}});
  for (const auto& series : over_stiffness_ratio(settings.quick))
    run(series, {"modal", "taylor"}, settings, {{"modal", "taylor"}});
  for (const double accuracy : {1e-6, 1e-10}) {
    auto with = settings;
    with.accuracy = accuracy;
    for (const auto& series : over_damping_ratio(accuracy, settings.quick)) {
      const auto& bdf = series.points.front().impact_case.balls == 3 ? dense : band;
      run(series, {"taylor", adams, bdf}, with, {{"taylor", adams}, {adams, bdf}, {"taylor", bdf}});
    }
    run(over_linear_chains(accuracy, settings.quick), {"modal", "taylor", adams}, with,
        {{"modal", "taylor"}, {"modal", adams}});
  }
  findings.figures = figures_by_flow(findings.rows, "balls or damping ratio", Figure::Quantity::seconds);
  return findings;
}

}  // namespace mariotte::stiffness_study
