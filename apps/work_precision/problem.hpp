// The problems: chains with final velocities known to more digits than a double holds.
//
//   P1        three equal Hertz balls touching, v = (1, 0, 0)
//   P2-κ      the same with stiffness ratio κ = k2/k1 and v = (1, 0, −1/2)
//   P3-κ      three equal balls on linear springs touching, stiffness ratio κ, v = (1, 0, 0)
//   P4        21 equal Hertz balls touching, the first strikes
//   V-c       P1 with viscoelastic contacts of exponent 3/2 and damping c
//   map       64 × 64 Hertz triplets: κ = 0.1 … 10 evenly in the logarithm, v3 = −1 … 0
//
// Unless said otherwise k = m = v1 = 1.
#pragma once
#include <string>
#include <vector>

#include "mariotte/model/chain.hpp"

namespace mariotte::work_precision {

/// One impact and what is known of it.
struct Case {
  model::Chain chain;
  std::vector<long double> velocity;  ///< final velocities
  double end;                         ///< time of the last separation
  std::vector<Index> periods;         ///< how often each contact closes; empty if not compared
};

struct Problem {
  std::string name;
  std::vector<Case> cases;  ///< one, or the points of a map
};

/// Names of all problems, in the order in which they are run.
std::vector<std::string> problem_names();

/// The problem of that name; of a map only every `stride`-th point along both axes.
Problem problem(const std::string& name, std::size_t stride);

}  // namespace mariotte::work_precision
