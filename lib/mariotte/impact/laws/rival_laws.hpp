// The usual impact laws side by side, for comparison with the multiple-impact law.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {

/// What the laws need beside the configuration.
struct RivalParameters {
  double restitution = 1;   ///< e of every contact, 0 ≤ e ≤ 1
  bool distributes = true;  ///< all contacts are k δ^η: Liu, Zhao & Brogliato's law knows no others
  std::vector<double> stiffness = {};  ///< k of that law, one per contact; empty for equal ones
  std::vector<double> exponent = {};   ///< η of that law, one per contact; empty for Hertz ones
  std::vector<double> direction =
      {};  ///< impulses up to their size, for Ceanga & Hurmuzlu's law; may be empty
};

/// A law by name, and what it answers.
struct NamedOutcome {
  std::string name;
  LawOutcome outcome;
};

/// "newton", "poisson", "moreau", "left-to-right", "by-event", "liu-zhao-brogliato" for e > 0 and contacts
/// that it knows, and with a direction "ceanga-hurmuzlu".
std::vector<NamedOutcome> rival_outcomes(const Configuration& configuration,
                                         const RivalParameters& parameters);

/// How far the kinetic energy is spread over the dofs of a diagonal mass matrix: 1 − Σ s² with the
/// shares s, 0 if one has all, 1 − 1/n if n share it evenly.
double energy_dispersion(const Configuration& configuration, const std::vector<double>& velocity);

}  // namespace mariotte::impact
