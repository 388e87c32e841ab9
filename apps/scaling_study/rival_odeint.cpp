// Boost.odeint: the Runge–Kutta–Fehlberg pair of orders 7 and 8 with step control.
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "mariotte/core/error.hpp"
#include "method.hpp"
#include "whole_row.hpp"
#include "work_precision/timing.hpp"

namespace mariotte::scaling_study {

Measurement measure_odeint(std::size_t balls) {
  namespace odeint = boost::numeric::odeint;
  using State = std::vector<double>;
  constexpr double tolerance = 1e-10;
  const WholeRow row{balls};
  State x(row.size());
  row.start(x.data());
  const auto derivative = [&](const State& at, State& dx, double) { row(at.data(), dx.data()); };
  auto stepper =
      odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance, longest_step);
  const double end = row.end(), start = work_precision::cpu_seconds();
  double time = 0, step = 1e-3;
  Index steps = 0;
  while (end - time > epsilon * end) {
    step = std::min(step, end - time);
    if (step < epsilon * time) throw Error("the step of odeint has shrunk to nothing");
    steps += stepper.try_step(derivative, x, time, step) == odeint::success;
  }
  return {.seconds = work_precision::cpu_seconds() - start,
          .error = error_of(row.velocity(x.data())),
          .steps = steps,
          .widest = static_cast<Index>(row.contacts())};
}

}  // namespace mariotte::scaling_study
