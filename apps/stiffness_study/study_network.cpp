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

}  // namespace

Findings network_study(const Settings& settings) {
  Findings findings;
  References references(settings.patience());
  const std::string dense = "cvode-bdf-dense", klu = "cvode-bdf-klu";
  auto loose = settings;  // what a matrix costs does not depend on the number of steps
  loose.accuracy = 1e-6;
  findings.rows = sweep(over_packings(settings.quick), {dense, klu}, loose, references);
  findings.statements = {comparison(findings.rows, dense, klu)};
  findings.figures = figures_by_flow(findings.rows, "disks on a side", Figure::Quantity::seconds);
  return findings;
}

}  // namespace mariotte::stiffness_study
