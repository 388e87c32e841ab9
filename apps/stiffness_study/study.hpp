// The studies: what each varies and what it must find.
#pragma once
#include <string>
#include <vector>

#include "figure.hpp"
#include "statement.hpp"
#include "sweep.hpp"

namespace mariotte::stiffness_study {

struct Findings {
  Rows rows;
  std::vector<Statement> statements;
  std::vector<Figure> figures;
};

struct Study {
  std::string name;  ///< on the command line
  std::string title;
  bool by_default;
  Findings (*run)(const Settings& settings);
};

const std::vector<Study>& studies();

/// k = 1 … 1e30 and masses: instants in ωt, ICRs and velocities / v depend on neither [Acary 2003,
/// Prop. 2.1].
Findings stiffness_study(const Settings& settings);
/// κ = 1 … 1e10 (linear), 1 … 1e6 (Hertz): what stiffness beside softness costs.
Findings ratio_study(const Settings& settings);
/// c = 0 … 1e4 (triplets 1e6): what damping costs.
Findings damping_study(const Settings& settings);
/// Damped contacts: ICRs are constant along c ∝ k^{n/(n+1)}, and not otherwise.
Findings scaling_study(const Settings& settings);
/// What [Acary 2003, §4] concludes for finite-dimensional systems, on chains at random. 2(b) is the scaling
/// study.
Findings conclusions_study(const Settings& settings);
/// Where one flow becomes cheaper than another: numbers for flow/choose.
Findings crossover_study(const Settings& settings);
/// Packings of disks: what a dense and a sparse matrix cost where no band fits.
Findings network_study(const Settings& settings);
/// A packing struck at its corner: what a run costs, and in how many parts the contacts push.
Findings packing_study(const Settings& settings);

}  // namespace mariotte::stiffness_study
