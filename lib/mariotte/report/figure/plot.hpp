// Figures of a run by gnuplot: contact forces and velocities over time.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/report/figure/curve_names.hpp"

namespace mariotte::report {

/// The files that the script of a run makes.
const std::vector<std::string>& figure_names();

/// `plot.csv`: a block per curve, velocities before forces, with the number of the ball or contact, time [s]
/// and value [m/s or N]; only points that can be seen, and of a long chain evenly spaced balls and contacts.
std::string plot_data(const impact::Trace& trace);

/// `plot.gp`: a gnuplot script that reads plot.csv in its folder and makes forces and velocities, as PNG and
/// SVG, until soon after the last force above a thousandth of the largest; phases are shaded. They begin at
/// the start of the run or, after a long flight, soon before the first such force. The impact must have a
/// trace. More figures may follow on the same time axis.
std::string plot_script(const impact::ContactImpact& impact, const std::string& title,
                        const CurveNames& names = {});

/// The part of a run that its figures show [s].
struct Window {
  double start = 0;
  double end = 0;
};
Window window_of_action(const impact::Trace& trace);

/// The same two of a body: the forces on its tips and the velocity of its mass centre.
std::string plot_data(const impact::BodyTrace& trace);
std::string plot_script(const impact::MicrobodyImpact& impact, const std::string& title);

}  // namespace mariotte::report
