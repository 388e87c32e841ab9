// Stored results for microbodies, in extended precision.
#pragma once
#include <nlohmann/json.hpp>

#include "strike.hpp"

namespace mariotte::paper_figures {

/// Restitution, final state and events of a dumbbell at 2 m/s or a rod at 2 or 5 m/s. Throws
/// std::out_of_range if there is none.
nlohmann::json body_reference(const Strike& strike);

/// Rods of ρ_r = 10 at 5 m/s, with events. Throws std::out_of_range if there is none.
nlohmann::json rod_reference(double tilt, double friction);

/// Spheres of this radius [m] at many speeds.
std::vector<nlohmann::json> sphere_references(double radius);

}  // namespace mariotte::paper_figures
