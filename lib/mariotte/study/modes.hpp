// Small vibrations of the row or network of a scene.
#pragma once
#include <optional>

#include "mariotte/impact/modes/vibrations.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::study {

/// Static equilibrium and natural modes about it, without dampers.
struct Modes {
  impact::Rest rest;
  impact::Vibrations vibrations;
  std::optional<impact::BandEdges> bands;  ///< of a chain that repeats one ball or two
};

/// `end_force` [N] presses the ends of a chain. Throws SceneError for a scene without contacts that vibrate,
/// and InvalidParameter for an end force of a network, and where impact::rest does.
Modes modes(const scene::Scene& scene, std::optional<double> end_force = {});

}  // namespace mariotte::study
