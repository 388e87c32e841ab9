// What the curves of a figure are called, for readers of the scene.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/scene.hpp"

namespace mariotte::report {

struct CurveNames {
  std::vector<std::string> velocities;  ///< "ball 2", "wall", "ball 3 x"; or empty: numbers tell all
  /// "f_{4} (1–3)", in gnuplot's enhanced text; of bodies "floor–rod" for all that may touch; or empty
  std::vector<std::string> contacts;
  std::vector<std::string> bodies = {};  ///< each once; of [bodies] alone
  std::vector<Index> numbers = {};       ///< of contacts, if these are not the first ones; from 1
  Index dimension = 1;                   ///< velocities of a ball that follow each other
};

/// Of a chain with walls and of balls in the plane or in space; empty for others, and for scenes of so many
/// balls that no figure names them.
CurveNames curve_names(const scene::Scene& scene);

}  // namespace mariotte::report
