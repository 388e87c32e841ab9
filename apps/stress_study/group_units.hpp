// Sizes of bodies with friction, and by how much their numbers move results.
#pragma once
#include <optional>

#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::stress_study {

/// Of its spheres, from the mass centre.
double reach(const model::Body& body);

/// By their own size, about. Nothing for what can move only one way: bodies that touch are moved nowhere, and
/// not made to part or approach.
std::optional<double> unit_of(const model::Bodies& bodies, const impact::Parameter<model::Bodies>& one,
                              double speed);
/// Stencils reach four times as far, and gaps must not close.
double longest_step(const model::Bodies& bodies, const impact::Parameter<model::Bodies>& one, double unit);

}  // namespace mariotte::stress_study
