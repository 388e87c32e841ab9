// Small vibrations about a rest: M q̈ = −G diag(k) Gᵀ q.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/impact/modes/rest.hpp"

namespace mariotte::impact {

/// Natural modes about a rest, the slowest first. They are singular vectors of L⁻¹ G √k with M = L Lᵀ, so
/// slow modes have as many digits as fast ones.
struct Vibrations {
  std::vector<double> frequency;           ///< angular, > 0 [rad/s]
  std::vector<std::vector<double>> shape;  ///< by mode: displacements of the n dofs, the largest is ±1
  Index rigid_motions = 0;                 ///< modes without frequency
};

/// Of a network whose contacts have the stiffnesses of a rest.
Vibrations vibrations(const model::Network& network, const Rest& rest);
/// Of a chain.
Vibrations vibrations(const model::Chain& chain, const Rest& rest);

/// Where the bands of a row end that repeats one ball, or two in turn, with equal stiffnesses K [rad/s].
struct BandEdges {
  double acoustic_top;  ///< 2√(K/m) of equal balls; √(2K/M), M the heavier one of two
  std::optional<double> optical_bottom = {};  ///< √(2K/m) of two
  std::optional<double> optical_top = {};     ///< √(2K(1/m + 1/M)) of two
};
/// Of the balls between the walls, whose contacts with these may differ; empty for any other row [Kittel
/// 2005, ch. 4].
std::optional<BandEdges> band_edges(const model::Chain& chain, const Rest& rest);

}  // namespace mariotte::impact
