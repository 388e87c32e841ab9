// `material = { young = "210 GPa", poisson = 0.3, density = "7800 kg/m^3", yield_strength = "2 GPa" }`, or
// `material = "steel"`
#pragma once
#include <optional>

#include "mariotte/contact/hertz.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// What the scene says of a material; a missing value matters only where it is needed.
struct Material {
  std::optional<double> young;           ///< E [Pa]; infinite for a rigid body
  std::optional<double> poisson;         ///< ν; 0 for a rigid body, where it has no effect
  std::optional<double> density;         ///< ρ [kg/m³]
  std::optional<double> yield_strength;  ///< Y [Pa]; empty, too, for what does not yield

  bool operator==(const Material&) const = default;
};

/// Throws SceneError; warns of values that look like a slip in the unit.
Material read_material(Source& source, const Field& field);

/// ρ [kg/m³], with a warning where it looks like a slip in the unit.
double read_density(Source& source, const Field& field);

/// For contact stiffness; empty unless Young's modulus and Poisson's ratio are known.
std::optional<contact::Elasticity> elastic(const Material& material);

}  // namespace mariotte::scene
