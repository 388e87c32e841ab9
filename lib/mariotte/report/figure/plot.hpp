// Figures of a run by gnuplot: contact forces and velocities over time.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/report/figure/curve_names.hpp"
#include "mariotte/report/figure/time_figure.hpp"
#include "mariotte/scene/figure.hpp"

namespace mariotte::report {

/// The files that the script of a run makes.
const std::vector<std::string>& figure_names();

/// What gnuplot needs for the figures of a run.
struct RunPlot {
  std::string data;    ///< plot.csv: velocities before forces
  std::string script;  ///< plot.gp, which makes forces and velocities; more figures may follow
  TimeAxis axis;       ///< of all figures
};

/// Up to twelve balls or contacts are curves, in plot.csv a block per curve with number, time [s] and value
/// [m/s or N], only points that can be seen. More are images, a block per panel. The impact must have a
/// trace.
RunPlot plot(const impact::ContactImpact& impact, const std::string& title, const CurveNames& names = {},
             const scene::Figure& figure = {});

/// The forces on the tips of a body and the velocity of its mass centre; plot.csv has one line per sample.
RunPlot plot(const impact::MicrobodyImpact& impact, const std::string& title,
             const scene::Figure& figure = {});

/// Velocities of bodies and normal forces of their contacts, drawn as those of a network.
RunPlot plot(const impact::BodiesImpact& impact, const std::string& title, const CurveNames& names = {},
             const scene::Figure& figure = {});

}  // namespace mariotte::report
