// The inside of a run: velocities, gaps and forces at any times.
#pragma once
#include <vector>

#include "impact.hpp"

namespace mariotte::python {

/// One row per time, row-major.
struct Samples {
  std::vector<double> time;      ///< [s]
  std::vector<double> velocity;  ///< of balls, degrees of freedom, or a body's mass centre
  std::vector<double> gap;       ///< of contacts or tips [m]
  std::vector<double> force;     ///< [N]
  Index velocities = 0, contacts = 0;
};

/// At times [s] in order, from 0 to the ending of the impact, by its dense output: the scene is run again and
/// looked at then. It is run tighter until its end is that of the impact, to the accuracy that was asked for.
/// Called without the interpreter's lock.
Samples sample(const Impact& impact, const std::vector<double>& times);

/// At the times of its steps, as many as make a picture.
Samples steps(const Impact& impact);

}  // namespace mariotte::python
