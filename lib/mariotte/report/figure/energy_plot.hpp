// Where the energy of an impact is at every instant, as a figure.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/report/figure/time_figure.hpp"

namespace mariotte::report {

/// Along the samples of a trace [s, J].
struct EnergyCourse {
  std::vector<double> time;
  std::vector<double> kinetic;  ///< of the balls of finite mass
  std::vector<double> stored;   ///< in the contacts that carry force
  /// What is missing; empty with gravity, drives or moving walls, whose work the samples do not show.
  std::vector<double> lost;
};

/// Whether gaps tell what the contacts store: not where one yields or adheres.
bool knows_energies(const model::Chain& chain);

/// Of the trace of `impact`; in flight under gravity between the samples, too, where energies are no lines.
EnergyCourse energy_course(const impact::ChainImpact& impact, const model::Chain& chain);

/// `energy.csv`: time, kinetic, stored and lost energy.
std::string energy_csv(const EnergyCourse& course);

/// gnuplot commands that make the figure `energy` from it, to follow those of `plot`; if these leave out a
/// flight before the first contact that no user has left out, it has a panel of its own.
std::string energy_script(const EnergyCourse& course, const std::string& title, TimeAxis axis);

}  // namespace mariotte::report
