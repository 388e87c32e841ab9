// Spheres side by side.
#pragma once
#include <memory>

#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/flow/lanes/scene_lanes.hpp"
#include "mariotte/flow/sphere/sphere.hpp"

namespace mariotte::flow {

using SphereLanes = SceneLanes<Sphere>;

MARIOTTE_PER_INSTRUCTION_SET(std::unique_ptr<SphereLanes>, make_sphere_lanes, (), ())

}  // namespace mariotte::flow
