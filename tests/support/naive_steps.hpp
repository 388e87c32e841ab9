// Steps of the naive simulators: the Runge–Kutta pair of Dormand and Prince with step control, and no events.
#pragma once
#include <algorithm>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::test {

/// How well, and how long to try.
struct Effort {
  double tolerance = 1e-10;  ///< of a step, relative to natural depths and the speed
  double share = 0.3;        ///< longest step near a contact, in its natural time
  Index most_steps = 200000;
  double smoothing = 0.003;  ///< slip, in units of the speed, below which friction is less than it should be
};

/// Follow a field from time 0 to `end`, with steps no longer than it allows where it is; false if that takes
/// too many of them, or leads to what is not a number. A field may `accept` what a step led to.
template <class Field>
bool follow_naively(Field& field, std::vector<double>& y, double end, const Effort& effort, Index& steps) {
  namespace odeint = boost::numeric::odeint;
  using Pair = odeint::runge_kutta_dopri5<std::vector<double>>;
  using Checker = odeint::default_error_checker<double, odeint::range_algebra, odeint::default_operations>;
  odeint::controlled_runge_kutta<Pair, Checker> stepper(
      Checker(effort.tolerance, effort.tolerance, 0.0, 1.0));
  double time = 0, step = field.longest_step(y);
  while (end - time > 1e-15 * end) {
    if (++steps > effort.most_steps || !(step > 1e-16 * time)) return false;
    step = std::min({step, field.longest_step(y), end - time});
    const auto result = stepper.try_step(std::cref(field), y, time, step);
    if constexpr (requires { field.accept(y); })
      if (result == odeint::success) field.accept(y);
  }
  return std::all_of(y.begin(), y.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace mariotte::test
