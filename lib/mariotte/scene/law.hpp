// What a scene tells the multiple-impact law.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/impact/laws/multiple_impact_law.hpp"

namespace mariotte::scene {

/// What is not given is left to the chain of the scene and its simulation.
struct Law {
  std::vector<double> mass;       ///< n values [kg]; empty for those of the chain
  std::vector<double> velocity;   ///< n values [m/s]; empty for those of the chain
  std::vector<double> direction;  ///< r, n−1 values, from `direction` or `icr`; empty if neither is given
  std::optional<double> energy_ratio;
  impact::EnergyFrame frame = impact::EnergyFrame::given;
};

}  // namespace mariotte::scene
