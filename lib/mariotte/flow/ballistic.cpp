#include "mariotte/flow/ballistic.hpp"

#include <cmath>

#include "mariotte/flow/flows.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::flow {
namespace {

/// Roots of value + rate t + bend t²/2 without cancellation: q = −(rate ± √(rate² − 2 bend value)),
/// t = q / bend and t = 2 value / q. Falling crossings are at the root where the slope is negative.
double falling_root(double value, double rate, double bend) {
  if (bend == 0) return rate < 0 ? -value / rate : infinity;
  // Scale by the largest rate-like size so that squares neither overflow nor vanish.
  const double size = std::max(std::abs(rate), std::sqrt(std::abs(bend)) * std::sqrt(std::abs(value)));
  if (size == 0) return infinity;
  const double r = rate / size;
  const double discriminant = r * r - 2 * (bend / size) * (value / size);
  if (discriminant < 0) return infinity;
  const double root = std::sqrt(discriminant);
  // Slope at the crossing is −root: t = (−root − r) size / bend, or the same multiplied out.
  if (r <= 0) return 2 * (value / size) / (root - r);
  return -(root + r) * (size / bend);
}

}  // namespace

double first_crossing(Crossing crossing, double value, double rate, double bend) {
  if (crossing == Crossing::none) return infinity;
  const double sign = crossing == Crossing::falling ? 1 : -1;
  const double time = falling_root(sign * value, sign * rate, sign * bend);
  return time > 0 ? time : infinity;
}

namespace {

class Ballistic final : public Flow {
 public:
  bool admits(const Problem& problem) override { return problem.is_ballistic(); }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override {
    start_.assign(x.begin(), x.end());
    rate_.resize(x.size());
    bend_.resize(x.size());
    Index guard = -1;
    const double first = next_crossing(problem, x, guard);
    if (!std::isfinite(first) && !std::isfinite(request.limit)) return {.outcome = Outcome::never};
    const bool arrives = first <= request.limit;
    double duration = arrives ? first : request.limit;

    StepOf step([this](double time, State there) {
      for (std::size_t i = 0; i < there.size(); ++i)
        there[i] = start_[i] + time * (rate_[i] + 0.5 * time * bend_[i]);
    });
    step.before = start_;
    step.at(duration, x);
    step.end = duration;
    step.after = x;
    if (request.observer) request.observer->observe(step);
    if (arrives) {
      duration += land(problem, x, guard, duration);
      fired.push_back(guard);
      simultaneous_.collect(problem, x, simultaneity_window(problem, request.accuracy), fired);
    }
    return {.outcome = arrives ? Outcome::guard : Outcome::limit, .duration = duration, .steps = 1};
  }

 private:
  double next_crossing(const Problem& problem, ConstState x, Index& guard) {
    const auto count = problem.guard_count();
    for (auto* values : {&value_, &value_rate_, &value_bend_}) values->resize(count);
    problem.derivative(x, rate_);
    problem.second_derivative(x, bend_);
    problem.guards(x, value_);
    problem.guard_rates(x, rate_, value_rate_);
    problem.guard_rates(x, bend_, value_bend_);  // linear guards
    double first = infinity;
    for (Index i = 0; i < count; ++i) {
      const double time = first_crossing(problem.crossings()[i], value_[i], value_rate_[i], value_bend_[i]);
      if (time >= first) continue;
      first = time;
      guard = i;
    }
    return first;
  }

  /// A long flight ends with the rounding error of its whole height, which may be deeper than any contact.
  /// What is left of the way has a rounding error of its own, 2⁻⁵³ of the last, until contacts cannot feel
  /// it. Returns its time, of either sign.
  double land(const Problem& problem, State x, Index guard, double flight) {
    const double unfelt = 1e-8 * problem.time_scale();  // the energy of such an indentation is its square
    if (epsilon * flight <= unfelt) return 0;
    constexpr int most = 20;  // of 2⁻⁵³ are all that doubles hold
    double sum = 0;
    for (int i = 0; i < most; ++i) {
      problem.derivative(x, rate_);
      problem.guards(x, value_);
      problem.guard_rates(x, rate_, value_rate_);
      const double time = -value_[guard] / value_rate_[guard];
      if (!(std::abs(time) > unfelt) || !std::isfinite(time)) break;
      for (std::size_t k = 0; k < x.size(); ++k) x[k] += time * rate_[k];
      sum += time;
    }
    return sum;
  }

  Simultaneous simultaneous_;
  std::vector<double> start_, rate_, bend_, value_, value_rate_, value_bend_;
};

}  // namespace

std::unique_ptr<Flow> make_ballistic_flow() {
  return std::make_unique<Ballistic>();
}

}  // namespace mariotte::flow
