// Rivals from Boost.odeint: the Runge–Kutta–Fehlberg pair of orders 7 and 8 with step control, and
// Bulirsch–Stoer extrapolation. Neither locates events; forces are cut off at zero.
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "field.hpp"

namespace mariotte::work_precision {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr double first_step = 1e-3;
constexpr Index most_steps = 2'000'000;

/// What integrate_adaptive does, with a count of the steps.
template <class F, class Stepper>
void integrate(Stepper& stepper, const Case& one, Answer& answer) {
  const F field(one.chain);
  typename F::State x;
  F::start(one.chain, x.data());
  const auto derivative = [&](const typename F::State& at, typename F::State& dx, double) {
    ++answer.rhs;
    field(at.data(), dx.data());
  };
  const double end = overtime * one.end;
  double time = 0, step = first_step;
  for (Index tries = 0; end - time > epsilon * end; ++tries) {
    if (tries == most_steps || step < epsilon * time) throw Error("the step has shrunk to nothing");
    step = std::min(step, end - time);
    answer.steps += stepper.try_step(derivative, x, time, step) == odeint::success;
  }
  F::finish(x.data(), answer);
}

/// Steppers are copied into their controllers with work arrays and all; those of a static one are zeros.
template <class Stepper>
const Stepper& blank() {
  static const Stepper stepper;
  return stepper;
}

template <class F>
class Fehlberg {
 public:
  explicit Fehlberg(double tolerance)
      : stepper_(odeint::default_error_checker<double, odeint::array_algebra, odeint::default_operations>(
                     tolerance, tolerance),
                 odeint::default_step_adjuster<double, double>(longest_step), blank<Stepper>()) {}
  void solve(const Case& one, Answer& answer) { integrate<F>(stepper_, one, answer); }

 private:
  using Stepper = odeint::runge_kutta_fehlberg78<typename F::State>;
  odeint::controlled_runge_kutta<Stepper> stepper_;
};

template <class F>
class BulirschStoer {
 public:
  explicit BulirschStoer(double tolerance) : stepper_(tolerance, tolerance, 1, 1, longest_step) {}
  void solve(const Case& one, Answer& answer) {
    stepper_.reset();
    integrate<F>(stepper_, one, answer);
  }

 private:
  odeint::bulirsch_stoer<typename F::State> stepper_;
};

}  // namespace

std::vector<Method> odeint_rivals() {
  return {{.name = "odeint-rkf78", .family = Family::odeint, .prepare = rival<Fehlberg>},
          {.name = "odeint-bulirsch-stoer", .family = Family::odeint, .prepare = rival<BulirschStoer>}};
}

}  // namespace mariotte::work_precision
