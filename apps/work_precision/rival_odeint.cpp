// Rivals from Boost.odeint: the Runge–Kutta pairs of Dormand and Prince (orders 4 and 5) and of Fehlberg (7
// and 8) with step control, and Bulirsch–Stoer extrapolation. None locates events; forces are cut off at
// zero.
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "body_field.hpp"
#include "field.hpp"

namespace mariotte::work_precision {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr Index most_steps = 2'000'000;

template <class F, class Stepper>
void integrate(Stepper& stepper, const Case& one, const Setting& setting, Answer& answer) {
  const F field(one, setting);
  typename F::State x;
  field.start(one, x.data());
  const auto derivative = [&](const typename F::State& at, typename F::State& dx, double) {
    ++answer.rhs;
    field(at.data(), dx.data());
  };
  answer.steps += measuring::integrate(stepper, derivative, x, F::overtime * one.end, most_steps);
  field.finish(x.data(), answer);
}

/// Steppers are copied into their controllers with work arrays and all; those of a static one are zeros.
template <class Stepper>
const Stepper& blank() {
  static const Stepper stepper;
  return stepper;
}

template <class F, class Stepper>
class Controlled {
 public:
  explicit Controlled(const Setting& setting)
      : setting_(setting),
        stepper_(odeint::default_error_checker<double, odeint::array_algebra, odeint::default_operations>(
                     setting.value, setting.value),
                 odeint::default_step_adjuster<double, double>(measuring::longest_step), blank<Stepper>()) {}
  void solve(const Case& one, Answer& answer) {
    if constexpr (requires { stepper_.reset(); }) stepper_.reset();  // forget the last slope
    integrate<F>(stepper_, one, setting_, answer);
  }

 private:
  Setting setting_;
  odeint::controlled_runge_kutta<Stepper> stepper_;
};

template <class F>
struct Fehlberg : Controlled<F, odeint::runge_kutta_fehlberg78<typename F::State>> {
  using Controlled<F, odeint::runge_kutta_fehlberg78<typename F::State>>::Controlled;
};
template <class F>
struct DormandPrince : Controlled<F, odeint::runge_kutta_dopri5<typename F::State>> {
  using Controlled<F, odeint::runge_kutta_dopri5<typename F::State>>::Controlled;
};

template <class F>
class BulirschStoer {
 public:
  explicit BulirschStoer(const Setting& setting)
      : setting_(setting), stepper_(setting.value, setting.value, 1, 1, measuring::longest_step) {}
  void solve(const Case& one, Answer& answer) {
    stepper_.reset();
    integrate<F>(stepper_, one, setting_, answer);
  }

 private:
  Setting setting_;
  odeint::bulirsch_stoer<typename F::State> stepper_;
};

}  // namespace

std::vector<Method> odeint_rivals() {
  auto list = rivals<Fehlberg>("odeint-rkf78", Family::odeint, chain_rival<Fehlberg>);
  append(list, rivals<DormandPrince>("odeint-dopri5", Family::odeint));
  append(list, rivals<BulirschStoer>("odeint-bulirsch-stoer", Family::odeint, chain_rival<BulirschStoer>));
  return list;
}

}  // namespace mariotte::work_precision
