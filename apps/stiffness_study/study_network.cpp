#include <fmt/format.h>

#include "study.hpp"

namespace mariotte::stiffness_study {
namespace {

/// Many contacts per body, in no order that a band could follow.
Series over_packings(bool quick) {
  Series series{.study = "network",
                .name = "matrices of a packing of disks, damping ratio 20",
                .family = "disks on a side",
                .points = {},
                .longest = 1};
  for (const Index side : {2, 3, 4, 5, 6, 8, 12, 17})
    if (!quick || side <= 4)
      series.points.push_back({static_cast<double>(side),
                               {.law = "viscoelastic", .damping = damping_for(20, 1.5), .side = side}});
  return series;
}

/// Everything bounces, with redundant contacts in every square.
Series over_linear_packings(double accuracy, bool quick) {
  Series series{.study = "network",
                .name = fmt::format("modes of a packing of disks, accuracy {:.0e}", accuracy),
                .family = "disks on a side",
                .points = {},
                .longest = 1};
  for (const Index side : {2, 3, 4, 5, 6, 8})
    if (!quick || side <= 4)
      series.points.push_back({static_cast<double>(side), {.law = "linear", .side = side}});
  return series;
}

/// Bodies that share contacts, all of Hertz' law.
Series over_hertz_packings(bool quick) {
  Series series{.study = "network",
                .name = "series of a packing of disks, accuracy 1e-10",
                .family = "disks on a side",
                .points = {},
                .longest = 1};
  for (const Index side : {2, 3, 4, 5, 6, 8, 12, 17})
    if (!quick || side <= 4)
      series.points.push_back({static_cast<double>(side), {.law = "hertz", .side = side}});
  return series;
}

}  // namespace

Findings network_study(const Settings& settings) {
  Findings findings;
  References references(settings.patience());
  const std::string dense = "cvode-bdf-dense", klu = "cvode-bdf-klu";
  auto loose = settings;  // what a matrix costs does not depend on the number of steps
  loose.accuracy = 1e-6;
  findings.rows = sweep(over_packings(settings.quick), {dense, klu}, loose, references);
  findings.statements = {comparison(findings.rows, dense, klu)};
  for (const double accuracy : {1e-6, 1e-10}) {
    auto demand = settings;
    demand.accuracy = accuracy;
    const auto rows =
        sweep(over_linear_packings(accuracy, settings.quick), {"modal", "cvode-adams"}, demand, references);
    findings.statements.push_back(comparison(rows, "modal", "cvode-adams"));
    findings.rows.insert(findings.rows.end(), rows.begin(), rows.end());
  }
  auto tight = settings;
  tight.accuracy = 1e-10;
  const auto series =
      sweep(over_hertz_packings(settings.quick), {"taylor", "cvode-adams"}, tight, references);
  findings.statements.push_back(comparison(series, "taylor", "cvode-adams"));
  findings.rows.insert(findings.rows.end(), series.begin(), series.end());
  findings.figures = figures_by_flow(findings.rows, "disks on a side", Figure::Quantity::seconds);
  return findings;
}

}  // namespace mariotte::stiffness_study
