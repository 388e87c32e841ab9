// Steps of the rivals: methods that integrate every ball at every step, with forces cut off at zero and no
// events, past an end that they are told.
#pragma once
#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <cstddef>
#include <limits>

#include "mariotte/core/error.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::measuring {

/// How far past the last separation rivals of chains integrate, in ends of the impact.
inline constexpr double overtime = 1.01;

/// Longest step of a rival that adapts it: in free flight it would leap over a late contact. The shortest
/// contacts last five times as long.
inline constexpr double longest_step = 0.5;

/// Velocity Verlet with a fixed step: kick, drift, kick. `field` has accelerations(gap, velocity,
/// acceleration) and says whether it is `damped`; forces that depend on velocities see those predicted by the
/// old acceleration, which keeps order 2. `Numbers` holds one value per ball, of which `blank` has the size.
template <class Field, class Numbers>
void verlet(const Field& field, double duration, Index steps, double* gap, double* velocity,
            const Numbers& blank) {
  const std::size_t balls = blank.size();
  const double h = duration / static_cast<double>(steps);
  Numbers acceleration = blank, predicted = Field::damped ? blank : Numbers();
  const double* seen = Field::damped ? predicted.data() : velocity;
  field.accelerations(gap, velocity, acceleration.data());
  for (Index step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < balls; ++i) {
      velocity[i] += 0.5 * h * acceleration[i];
      if constexpr (Field::damped) predicted[i] = velocity[i] + 0.5 * h * acceleration[i];
    }
    for (std::size_t j = 0; j + 1 < balls; ++j) gap[j] += h * (velocity[j + 1] - velocity[j]);
    field.accelerations(gap, seen, acceleration.data());
    for (std::size_t i = 0; i < balls; ++i) velocity[i] += 0.5 * h * acceleration[i];
  }
}

/// What integrate_adaptive of Boost.odeint does, with a count of the steps. Throws Error if the step shrinks
/// to nothing or is tried too often.
template <class Stepper, class Derivative, class State>
Index integrate(Stepper& stepper, const Derivative& derivative, State& x, double end,
                Index most_tries = std::numeric_limits<Index>::max()) {
  constexpr double first_step = 1e-3;
  double time = 0, step = first_step;
  Index steps = 0;
  for (Index tries = 0; end - time > epsilon * end; ++tries) {
    if (tries == most_tries || step < epsilon * time) throw Error("the step has shrunk to nothing");
    step = std::min(step, end - time);
    steps += stepper.try_step(derivative, x, time, step) == boost::numeric::odeint::success;
  }
  return steps;
}

}  // namespace mariotte::measuring
