// Microbodies of ammonium fluorescein on silicon as [Cheng 2002] strikes them.
#pragma once
#include <string>

#include "mariotte/impact/microbody/microbody_impact.hpp"

namespace mariotte::paper_figures {

/// Without spin and tangential velocity; α = γ = 0 and tilt β from the normal.
struct Strike {
  std::string shape = "rod";  ///< "sphere", "dumbbell" or "rod"
  double length_ratio = 10;   ///< ρ_r = L/r
  double tilt = 0;            ///< β [°]
  double friction = 0.15;     ///< μ
  double speed = 5;           ///< towards the plane [m/s]
  double radius = 2.45e-6;    ///< of the tips [m]
};

/// With the data of [Cheng 2002, Table 1, corrected], ζ_H = 1.5 and ζ_A = 0.5.
model::Microbody microbody(const Strike& strike);

impact::MicrobodyImpact simulate(const Strike& strike, bool trace = false);

}  // namespace mariotte::paper_figures
