// A phase followed by Boost.odeint and a bisection: a reference that shares nothing with any flow but the
// field and the guards.
#pragma once
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <vector>

#include "mariotte/flow/problem.hpp"

namespace mariotte::test {

/// Where a phase has come to: its first event, or the time asked for.
struct PhaseEnd {
  double duration = 0;
  std::vector<double> x;
  std::vector<Index> fired = {};  ///< in order
};

/// Steps of Runge, Kutta and Fehlberg, of order 8, without control: its estimate does not see the singular
/// start and end of a force. They shrink in proportion to the distance from both.
class FieldReference {
 public:
  using State = std::vector<double>;
  explicit FieldReference(flow::Problem& problem) : problem_(problem) {}

  /// To the first event, which lies near `end`, or to `limit`.
  PhaseEnd follow(State x, double end, double limit) {
    const double scale = problem_.time_scale(), shortest = 1e-9 * scale;
    double time = 0;
    while (time < limit) {
      const double away = std::min(time, std::abs(end - time));
      const double step = std::min({0.01 * scale, 0.1 * away + shortest, limit - time});
      const auto after = advanced(x, step);
      if (!crossed(x, after).empty()) return event(x, time, step);
      problem_.accept(after);
      x = after;
      time += step;
    }
    return {limit, x};
  }

 private:
  State advanced(State x, double step) const {
    const auto field = [this](const State& at, State& dx, double) { problem_.derivative(at, dx); };
    boost::numeric::odeint::runge_kutta_fehlberg78<State>().do_step(field, x, 0, step);
    return x;
  }
  State guards(const State& x) const {
    State values(problem_.guard_count());
    problem_.guards(x, values);
    return values;
  }
  /// A guard that is zero before does not cross.
  std::vector<Index> crossed(const State& before, const State& after) const {
    const auto from = guards(before), to = guards(after);
    std::vector<Index> list;
    for (Index i = 0; i < problem_.guard_count(); ++i) {
      const double way = static_cast<double>(problem_.crossings()[i]);
      if (way * from[i] < 0 && way * to[i] >= 0) list.push_back(i);
    }
    return list;
  }
  /// The first of the guards that cross within a step, and those that cross with it.
  PhaseEnd event(const State& before, double start, double step) const {
    double low = 0, high = step;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (crossed(before, advanced(before, middle)).empty() ? low : high) = middle;
    }
    const double together = 1e-10 * problem_.time_scale();  // above the reference's own errors
    return {start + high, advanced(before, high), crossed(before, advanced(before, high + together))};
  }

  flow::Problem& problem_;
};

}  // namespace mariotte::test
