// Boost.odeint: the Runge–Kutta–Fehlberg pair of orders 7 and 8 with step control.
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "measuring/timing.hpp"
#include "method.hpp"
#include "whole_row.hpp"

namespace mariotte::scaling_study {

Measurement measure_odeint(std::size_t balls) {
  namespace odeint = boost::numeric::odeint;
  using State = std::vector<double>;
  constexpr double tolerance = 1e-10;
  const WholeRow row{balls};
  State x(row.size());
  row.start(x.data());
  const auto derivative = [&](const State& at, State& dx, double) { row(at.data(), dx.data()); };
  auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance,
                                                                                measuring::longest_step);
  const double start = measuring::cpu_seconds();
  const Index steps = measuring::integrate(stepper, derivative, x, row.end());
  return {.seconds = measuring::cpu_seconds() - start,
          .error = error_of(row.velocity(x.data())),
          .steps = steps,
          .widest = static_cast<Index>(row.contacts())};
}

}  // namespace mariotte::scaling_study
