// The state of a microbody: gap of each tip, tangential position, velocity, attitude, angular momentum and,
// if they are wanted, the energies dissipated by Hertz damping, adhesion damping and friction.
#pragma once
#include <string>

#include "mariotte/core/state_vectors.hpp"
#include "mariotte/flow/tip_phase.hpp"
#include "mariotte/model/microbody/dimensionless_microbody.hpp"

namespace mariotte::model {

/// Where in the state of a body what is found.
struct MicrobodyLayout {
  flow::BodyPlaces place;
  Index size = 0;
  Index tips = 1;
};

/// Of a body with so many tips, with or without the integrals of a balance.
MicrobodyLayout microbody_layout(std::size_t tips, bool balance);

/// State at the start.
std::vector<double> initial_state(const DimensionlessMicrobody& body, const MicrobodyLayout& layout);

/// Natural size of each component: an error of accuracy × size is what the user allows.
std::vector<double> magnitudes(const DimensionlessMicrobody& body, const MicrobodyLayout& layout);

/// "velocity 2", "attitude 1", … for messages; counted from 1.
std::string component_name(const MicrobodyLayout& layout, Index component);

}  // namespace mariotte::model
