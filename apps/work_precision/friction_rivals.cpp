#include "friction_rivals.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "dem_field.hpp"

namespace mariotte::work_precision {
namespace {

namespace odeint = boost::numeric::odeint;

using State = DemField::State;
using Run = std::function<State(double setting)>;

/// Steps are no longer than a part of a contact, which they would leap over.
State by_odeint(const DemField& field, double end, double tolerance) {
  using Stepper = odeint::runge_kutta_dopri5<State>;
  odeint::controlled_runge_kutta<Stepper> stepper(
      odeint::default_error_checker<double, odeint::range_algebra, odeint::default_operations>(tolerance,
                                                                                               tolerance),
      odeint::default_step_adjuster<double, double>(0.3 * field.contact_time()));
  State x = field.start();
  double time = 0, step = 0.01 * field.contact_time();
  const auto derivative = [&](const State& at, State& slope, double) { field(at, slope); };
  while (end - time > epsilon * end) {
    step = std::min(step, end - time);
    if (stepper.try_step(derivative, x, time, step) != odeint::success) continue;
    field.settle(x);
    stepper.reset();
  }
  return x;
}

State by_verlet(const DemField& field, double end, double steps) {
  State x = field.start(), dx(x.size());
  for (double i = 0; i < steps; ++i) field.verlet(end / steps, x, dx);
  return x;
}

std::vector<RivalPoint> points(const std::vector<double>& settings, const DemField& field, const Run& run,
                               const VelocityError& error, const measuring::Patience& patience) {
  std::vector<RivalPoint> list;
  for (const double setting : settings) {
    State x;
    const double first = measuring::timed([&] { x = run(setting); });
    list.push_back(
        {measuring::least_seconds([&] { run(setting); }, first, patience), error(field.velocities(x))});
    if (first > patience.longest) break;
  }
  return list;
}

std::vector<double> geometric(double first, double factor, int count) {
  std::vector<double> list = {first};
  while (std::ssize(list) < count) list.push_back(factor * list.back());
  return list;
}

}  // namespace

FrictionRivals friction_rivals(const model::Bodies& bodies, double end, const VelocityError& error,
                               const measuring::Patience& patience) {
  if (!DemField::admits(bodies)) return {};
  const DemField field(bodies);
  const double time = end / field.time();
  const auto odeint_run = [&](double tolerance) { return by_odeint(field, time, tolerance); };
  const auto verlet_run = [&](double steps) { return by_verlet(field, time, steps); };
  return {points(geometric(1e-4, 0.1, 11), field, odeint_run, error, patience),
          points(geometric(1000, 4, 12), field, verlet_run, error, patience)};
}

std::optional<double> least_time(const std::vector<RivalPoint>& points, double accuracy) {
  std::optional<double> least;
  for (const auto& point : points)
    if (point.error <= accuracy && (!least || point.seconds < *least)) least = point.seconds;
  return least;
}

}  // namespace mariotte::work_precision
