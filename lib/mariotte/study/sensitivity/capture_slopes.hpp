// How the capture velocity of a microbody, or of two bodies of a chain, changes with numbers of its scene.
//
// At the capture velocity v_c the restitution e vanishes, and e² with a slope that does not. So
// dv_c/dp = −(∂e/∂p)/(∂e/∂v) there. Both grow without bound at v_c, and their quotient is taken at speeds a
// little above it. It differs from its limit by powers 1, 3/2 and 2 of the distance, since what damping takes
// on the way out depends on the speed there: four distances eliminate these.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/scene/document.hpp"

namespace mariotte::study {

inline constexpr const char* capture_velocity_name = "capture_velocity";

/// The one outcome "capture_velocity" [m/s] and its slopes by `keys`, as `sensitivity` has them; without keys
/// by all numbers but the speed. Throws SceneError for anything but a microbody with one impact or a pair,
/// and for what is never captured; Error as `capture_velocity`.
impact::Sensitivity sensitivity_of_capture(const scene::Document& document,
                                           const std::vector<std::string>& keys,
                                           const impact::SlopeWatch& watch);

}  // namespace mariotte::study
