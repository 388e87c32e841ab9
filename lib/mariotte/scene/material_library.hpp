// Materials that scenes can name, each value with where it is from.
#pragma once
#include <optional>
#include <span>
#include <string_view>

namespace mariotte::scene {

/// A number and who says so.
struct Sourced {
  double value;
  std::string_view source;
};

/// Typical values at room temperature; one's own material may differ, alloys and polymers by much.
struct NamedMaterial {
  std::string_view name;                  ///< as scenes spell it
  std::string_view kind;                  ///< what exactly it is
  Sourced young;                          ///< E [Pa]
  Sourced poisson;                        ///< ν
  Sourced density;                        ///< ρ [kg/m³]
  std::optional<Sourced> yield_strength;  ///< yield strength [Pa]; empty where it breaks before it yields
};

/// In alphabetical order.
std::span<const NamedMaterial> named_materials();

}  // namespace mariotte::scene
