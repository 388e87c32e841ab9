// The balls of a chain and their masses.
#pragma once
#include <vector>

#include "mariotte/scene/layout.hpp"
#include "mariotte/scene/material.hpp"

namespace mariotte::scene {

struct Ball {
  std::optional<double> mass;    ///< [kg]; infinite for a wall
  std::optional<double> radius;  ///< [m]; infinite for a plane
  std::optional<Material> material;
  std::optional<double> velocity;  ///< [m/s]
};

/// Takes mass, radius and material from a table, as far as it has them.
void read_properties(Source& source, const Field& table, Ball& ball);

/// The mass of ball i (from 0) by its radius and density; `table` is where that should be said.
double solid_sphere(const Source& source, const Field& table, const Ball& ball, Index i);

/// One per ball of the model, walls included: from the keys of [chain], then the [[chain.ball]] tables. A
/// missing mass is that of a solid sphere; a missing velocity stays missing and means rest. Throws
/// SceneError.
std::vector<Ball> read_balls(Source& source, const Field& chain, const Layout& layout);

}  // namespace mariotte::scene
