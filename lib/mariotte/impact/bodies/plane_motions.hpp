// How bodies in the plane move at an instant, apart from where they are.
#pragma once
#include <vector>

#include "mariotte/impact/bodies/first_impact.hpp"

namespace mariotte::impact {

/// How all bodies move.
std::vector<PlaneMotion> motions(const model::Bodies& bodies);
/// What these bodies would have with other motions [J].
double kinetic_energy(const model::Bodies& bodies, const std::vector<PlaneMotion>& motions);

}  // namespace mariotte::impact
