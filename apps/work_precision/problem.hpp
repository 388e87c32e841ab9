// The problems: impacts with known final velocities, of chains to more digits than a double holds, of bodies
// to the last digits of one.
//
//   P1        three equal Hertz balls touching, v = (1, 0, 0)
//   P2-κ      the same with stiffness ratio κ = k2/k1 and v = (1, 0, −1/2)
//   P3-κ      three equal balls on linear springs touching, stiffness ratio κ, v = (1, 0, 0)
//   P4        21 equal Hertz balls touching, the first strikes
//   V-c       P1 with viscoelastic contacts of exponent 3/2 and damping c
//   B-sphere  a microsphere, 4.9 µm, strikes a plane at 5 m/s along the normal
//   B-rod-μ   a rod of length ratio 10, tilted by 42°, at 5 m/s, with friction μ: it slides all the time or
//             sticks in between
//   B-space   a rod of length ratio 4 that moves and spins in all directions, with friction 0.15
//   map       64 × 64 Hertz triplets: κ = 0.1 … 10 evenly in the logarithm, v3 = −1 … 0
//
// Unless said otherwise k = m = v1 = 1; bodies have the adhesion and damping of [Cheng 2002, Table 1].
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/microbody/dimensionless_microbody.hpp"

namespace mariotte::work_precision {

/// A body as its user states it, and as rivals get it: in units of order one.
struct Body {
  model::Microbody stated;
  model::DimensionlessMicrobody scaled;
};

/// One impact and what is known of it.
struct Case {
  std::variant<model::Chain, Body> model;
  /// Final velocities; of a body velocity and reach × spin, both relative to the incident speed.
  std::vector<long double> velocity;
  double end;                       ///< time of the last separation, of a body in its scaled units
  std::vector<Index> periods = {};  ///< how often each contact closes; empty if not compared
};

/// The one or the other, where it is known which.
inline const model::Chain& chain_of(const Case& one) {
  return std::get<model::Chain>(one.model);
}
inline const Body& body_of(const Case& one) {
  return std::get<Body>(one.model);
}

struct Problem {
  std::string name;
  std::vector<Case> cases;  ///< one, or the points of a map

  bool has_body() const { return std::holds_alternative<Body>(cases.front().model); }
  bool has_friction() const { return has_body() && body_of(cases.front()).scaled.friction.coefficient > 0; }
};

/// Names of all problems, in the order in which they are run.
std::vector<std::string> problem_names();

/// The problem of that name; of a map only every `stride`-th point along both axes.
Problem problem(const std::string& name, std::size_t stride);

}  // namespace mariotte::work_precision
