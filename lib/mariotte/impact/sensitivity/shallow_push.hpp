// What slopes get from a contact that has just begun, to first order in its stiffness: its own slopes go on
// straight.
#pragma once
#include <cmath>
#include <vector>

#include "mariotte/contact/power_law.hpp"
#include "mariotte/flow/flow.hpp"
#include "mariotte/impact/sensitivity/gauss.hpp"

namespace mariotte::impact {

/// Slopes of an impulse and of its integral, per slope of the depth and of its rate at the start.
struct ShallowPush {
  double impulse_by_depth = 0, impulse_by_rate = 0;
  double travel_by_depth = 0, travel_by_rate = 0;
  double spring = 0, damper = 0;  ///< at most, what bends of a depth and of a rate do to the impulse
};

/// Of the contact with this law and gap, from δ = 0 on; `approach` is its rate in a state. Forces are powers
/// of the root of time.
template <class Approach>
ShallowPush shallow_push(const flow::Step& step, const contact::PowerLaw& law, Index gap,
                         Approach&& approach) {
  const double h = step.end - step.start;
  std::vector<double> x(step.before.size());
  ShallowPush sum;
  for (int i = 0; i < stages; ++i) {
    const double time = h * gauss.point[i] * gauss.point[i], left = h - time;
    step.at(step.start + time, x);
    const auto force = contact::smooth_force(law, -x[gap], approach(x));
    const double width = 2 * h * gauss.point[i] * gauss.weight[i];
    const double by_depth = width * force.by_indentation, damping = width * force.by_rate;
    const double by_rate = damping + time * by_depth;
    sum.impulse_by_depth += by_depth;
    sum.impulse_by_rate += by_rate;
    sum.travel_by_depth += left * by_depth;
    sum.travel_by_rate += left * by_rate;
    sum.spring += std::abs(by_depth);
    sum.damper += damping;
  }
  return sum;
}

}  // namespace mariotte::impact
