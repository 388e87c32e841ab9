// Stored results in extended precision.
#pragma once
#include <nlohmann/json.hpp>

#include "triplet.hpp"

namespace mariotte::paper_figures {

/// Final velocities, impulses and contact periods. Throws std::out_of_range if there is none, as do the
/// others.
nlohmann::json reference(const Triplet& triplet);

/// n touching Hertz balls, the first of which strikes the others.
nlohmann::json equal_chain_reference(std::size_t balls);

/// Touching Hertz balls of unlike radii by name: "10-50-10", "21-big10".
nlohmann::json big_ball_reference(const std::string& name);

}  // namespace mariotte::paper_figures
