// Spheres side by side: one in each lane of a register.
#pragma once
#include <memory>
#include <span>

#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/flow/sphere/sphere.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"

namespace mariotte::flow {

/// What a sphere does does not depend on those beside it: a lane knows nothing of the others.
class SphereLanes {
 public:
  virtual ~SphereLanes() = default;
  /// From where they touch to where they leave, or another solver has to tell. A lane whose sphere has come
  /// to that takes the next one.
  virtual void follow(std::span<Sphere* const> spheres, const taylor::Precision& precision) = 0;
};

MARIOTTE_PER_INSTRUCTION_SET(std::unique_ptr<SphereLanes>, make_sphere_lanes, (), ())

}  // namespace mariotte::flow
