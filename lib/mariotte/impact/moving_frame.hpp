// What flies as a whole much faster than its balls move among themselves. Rounding of the common velocity
// would hide what dampers do, and make flows creep; seen by somebody who flies along, it does not.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/laws/restitution.hpp"
#include "mariotte/impact/watch/observers.hpp"

namespace mariotte::impact {

/// A velocity that all balls share, and what it is of the largest speed.
struct MovingFrame {
  std::array<double, 3> velocity = {};  ///< by coordinate [m/s]
  std::size_t dimension = 0;            ///< coordinates of a ball; 0 if there is no frame worth entering
  double share = 1;                     ///< largest speed within the frame, relative to the largest outside

  explicit operator bool() const { return dimension > 0; }
  double at(std::size_t place) const { return velocity[place % dimension]; }
};

/// The frame of the first ball if all others keep within a tenth of its velocity; of coordinates in turn,
/// at most three of a ball.
MovingFrame frame_of_first(std::span<const double> velocities, std::size_t dimension);

/// Velocities as seen in the frame, and from outside again.
void enter(const MovingFrame& frame, std::vector<double>& velocities);
void leave(const MovingFrame& frame, std::vector<double>& velocities);

/// A model with velocities as seen in the frame.
template <class Model>
Model within(const MovingFrame& frame, Model model) {
  if (frame) enter(frame, model.velocity);
  return model;
}

/// Observers who are told velocities as seen from outside.
RunObserver from_outside(const MovingFrame& frame, RunObserver observers);

/// `run(model, observers)` of what is seen in the frame, if there is one; the result as seen from outside.
template <class Model, class Run>
auto run_within(const MovingFrame& frame, const Model& model, const RunObserver& observers, Run&& run) {
  if (!frame) return run(model, observers);
  auto impact = run(within(frame, model), from_outside(frame, observers));
  leave(frame, model, impact);
  return impact;
}

/// Velocities, trace and energy as seen from outside again: `start` are the velocities there, and
/// `kinetic(velocities)` is the energy of some.
template <class Kinetic>
void leave(const MovingFrame& frame, std::vector<double> start, Kinetic&& kinetic, ContactImpact& impact) {
  const double before = kinetic(start);
  enter(frame, start);
  leave(frame, impact.velocity);
  for (auto& row : impact.trace.velocity) leave(frame, row);
  impact.energy.initial += before - kinetic(start);
  impact.energy.final = kinetic(impact.velocity);
  impact.energy.ratio_lab = energy_ratio(impact.energy.final, before);
}

}  // namespace mariotte::impact
