// One `[[bodies.body]]`: its shape, mass and motion.
#pragma once
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/scene/balls.hpp"

namespace mariotte::scene {

/// A body, and what its contacts need to know of it.
struct ShapedBody {
  model::Body body;
  Ball ball;  ///< mass, radius where all spheres have one, material
};

/// Keys that hold for all bodies if [bodies] has them: shape, radius, diameter, mass, density, material.
ShapedBody read_shaped_body(Source& source, const Field& table, const Field& bodies, int dimension, Index i);

/// An array of `dimension` finite numbers; the third is 0 in the plane.
Vector3 read_coordinates(const Source& source, const Field& field, const Dimension& dimension, int count);

}  // namespace mariotte::scene
