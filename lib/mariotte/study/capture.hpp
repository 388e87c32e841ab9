// The capture velocity of a scene.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "mariotte/impact/microbody/capture_velocity.hpp"
#include "mariotte/scene/document.hpp"

namespace mariotte::study {

inline constexpr const char* speed_key = "incidence.normal_speed";  ///< of a microbody
inline constexpr const char* no_capture_velocity =
    "no capture velocity within a factor of a million of the scene's speed: bodies always part again, as "
    "without damping or with one restitution at all speeds, or never, as with very strong damping";

/// Between which a tolerance lies: rounding, and what tells nothing.
inline constexpr double finest_capture = 1e-15, widest_capture = 0.5;

/// Of a microbody, or of two bodies of a chain. Found from the scene's normal speed, or approach, on; all
/// else is as the scene says, but for the damping that ζ's or a restitution stand for where they depend on
/// the speed. `watch` is called before every impact; what it throws ends the search. Throws SceneError for a
/// scene of anything else, InvalidParameter for a tolerance that is none, and what impact::capture_velocity
/// throws.
std::optional<impact::CaptureVelocity> capture_velocity(
    scene::Document document, double tolerance, const std::function<void()>& watch = [] {});

/// Two bodies of a chain as they strike at a speed [m/s], without gap and gravity.
model::Chain struck(model::Chain pair, double speed);

/// The scene of such an impact at a speed. Of a pair all but its contact is left out: gap, gravity and
/// limits.
scene::Scene at_speed(scene::Document document, double speed);

}  // namespace mariotte::study
