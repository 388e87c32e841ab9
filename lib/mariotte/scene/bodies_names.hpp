// What scenes call bodies, their spheres and planes.
#pragma once
#include <string>
#include <vector>

#include "mariotte/model/bodies/bodies.hpp"

namespace mariotte::scene {

/// One way to name something that touches.
struct Called {
  std::string word;
  std::vector<model::Feature> features;  ///< all spheres of a body, one of them, or a plane
  bool is_given = false;                 ///< by the scene, and not "body 1" or "plane 1"
  bool is_whole = true;                  ///< no single sphere, "rod.2"
};

/// Of a body.
std::vector<model::Feature> all_spheres(const model::Bodies& bodies, Index body);

/// All of them: bodies before planes.
std::vector<Called> called(const model::Bodies& bodies);

}  // namespace mariotte::scene
