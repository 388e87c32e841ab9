// Figures of a run by gnuplot: contact forces and velocities over time.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/report/figure/curve_names.hpp"
#include "mariotte/report/figure/time_figure.hpp"
#include "mariotte/scene/figure.hpp"

namespace mariotte::report {

/// All figures that a script of a run may make, without their endings; the energy is drawn by itself.
inline constexpr std::array figures_of_runs = {"forces", "velocities", "friction", "spins"};

/// Numbers of one kind over the times of a run, and how a figure of them is called.
struct Series {
  std::string file, quantity, along, unit;
  Names names;
  std::vector<std::string> name;  ///< of curves
  std::vector<std::vector<double>> rows;
  std::vector<Index> number = {};  ///< of the lines of an image; empty: from 1
};

/// What gnuplot needs for the figures of a run.
struct RunPlot {
  std::string data;    ///< plot.csv: velocities before forces
  std::string script;  ///< plot.gp, which makes forces and velocities; more figures may follow
  std::vector<std::string> figures = {};  ///< that it makes
  TimeAxis axis = {};                     ///< of all figures
};

/// Up to twelve balls or contacts are curves, in plot.csv a block per curve with number, time [s] and value
/// [SI], only points that can be seen. More are images, a block per panel. The impact must have a
/// trace.
RunPlot plot(const impact::ContactImpact& impact, const std::string& title, const CurveNames& names = {},
             const scene::Figure& figure = {}, const std::vector<Series>& more = {});

/// The forces on the tips of a body and the velocity of its mass centre; plot.csv has one line per sample.
RunPlot plot(const impact::MicrobodyImpact& impact, const std::string& title,
             const scene::Figure& figure = {});

/// Velocities of bodies and normal forces of their contacts, drawn as those of a network, and friction and
/// spins by their components, or by magnitudes if these were too many; what is zero throughout is left out.
RunPlot plot(const impact::BodiesImpact& impact, const std::string& title, const CurveNames& names = {},
             const scene::Figure& figure = {});

}  // namespace mariotte::report
