// The impacts that are studied: equal balls in touch at rest, struck by the first, and packings of disks.
#pragma once
#include <string>

#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::stiffness_study {

/// Any consistent units; nothing is scaled here, the solver gets these numbers as they are.
struct ImpactCase {
  std::string law = "hertz";  ///< "linear", "hertz" or "viscoelastic"
  Index balls = 3;
  double stiffness = 1;   ///< k of contacts 1, 3, 5 … [N/m^n]
  double ratio = 1;       ///< κ: contacts 2, 4, 6 … have κ k
  double mass = 1;        ///< of every ball [kg]
  double speed = 1;       ///< of the first ball [m/s]
  double damping = 0;     ///< c of every contact [N s/m^n]; viscoelastic contacts only
  double exponent = 1.5;  ///< n; viscoelastic contacts only
  Index side = 0;         ///< instead of a row, a square packing of side² disks that move hither and thither
  bool struck = false;    ///< the packing is hexagonal, and rests but for a disk at its corner
};

model::Chain chain(const ImpactCase& one);
model::Network packing(const ImpactCase& one);

/// n of the contact law.
double exponent(const ImpactCase& one);

/// T = L/v with L = (m v²/k)^{1/(n+1)} [s]; 1/ω of a linear contact.
double natural_time(const ImpactCase& one);

/// Π = c v^{(n−1)/(n+1)} k^{−n/(n+1)} m^{−1/(n+1)}: all that damped impacts depend on.
double damping_group(const ImpactCase& one);

/// c for a damping ratio as flow::choose sees it: c L^n/(m* v) with m* = m/2 the reduced mass and
/// k = m = v = 1.
double damping_for(double ratio, double exponent);

/// The same impact in units in which k = m = v = 1.
ImpactCase dimensionless(const ImpactCase& one);

}  // namespace mariotte::stiffness_study
