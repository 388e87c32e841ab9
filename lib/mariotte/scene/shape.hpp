// `[body]`: shape, size and mass.
#pragma once
#include "mariotte/model/microbody/rigid_body.hpp"
#include "mariotte/scene/field.hpp"
#include "mariotte/scene/material.hpp"

namespace mariotte::scene {

struct Shape {
  model::RigidBody body;
  std::optional<double> density;     ///< ρ [kg/m³], where the scene gives it
  std::optional<Material> material;  ///< where the scene gives it
};

/// Throws SceneError.
Shape read_shape(Source& source, const Field& body);

}  // namespace mariotte::scene
