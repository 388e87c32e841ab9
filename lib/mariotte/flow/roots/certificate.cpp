#include "mariotte/flow/roots/certificate.hpp"

#include "mariotte/core/bracket.hpp"

namespace mariotte::flow {
namespace {

/// Bisections until a dip that is still undecided is no deeper than rounding; and how many a step may cost,
/// since a guard that hovers in rounding noise stays undecided everywhere.
constexpr int deepest_dip = 40;
constexpr int most_bisections = 1000;

/// +1 for guards that fire falling, −1 for rising ones: seen with this sign, all are positive until they
/// fire.
double side(Crossing crossing) {
  return crossing == Crossing::rising ? -1 : 1;
}

}  // namespace

bool keeps_side(const GuardPoint& from, const GuardPoint& to) {
  const double third = (to.time - from.time) / 3;
  return from.value + third * from.rate >= 0 && to.value - third * to.rate >= 0;
}

bool stays_beyond(const GuardPoint& from, const GuardPoint& to) {
  const GuardPoint start{from.time, -from.value, -from.rate}, end{to.time, -to.value, -to.rate};
  return start.value > 0 && end.value > 0 && keeps_side(start, end);
}

void Certificate::evaluate(const Problem& problem, ConstState x, std::vector<double>& values,
                           std::vector<double>& rates) {
  values.resize(problem.guard_count());
  rates.resize(problem.guard_count());
  dx_.resize(x.size());
  problem.derivative(x, dx_);
  problem.guards(x, values);
  problem.guard_rates(x, dx_, rates);
}

void Certificate::begin(const Problem& problem, ConstState x) {
  evaluate(problem, x, value_, rate_);
}

GuardPoint Certificate::point(const Problem& problem, const Step& step, Index guard, double time) {
  x_.resize(step.after.size());
  step.at(time, x_);
  evaluate(problem, x_, inner_value_, inner_rate_);
  const double sign = side(problem.crossings()[guard]);
  return {time, sign * inner_value_[guard], sign * inner_rate_[guard]};
}

std::optional<double> Certificate::search(const Problem& problem, const Step& step, Index guard,
                                          const GuardPoint& from, const GuardPoint& to, int depth) {
  if (keeps_side(from, to) || stays_beyond(from, to)) return std::nullopt;
  if (depth == deepest_dip || ++bisections_ > most_bisections) return std::nullopt;
  const auto middle = point(problem, step, guard, 0.5 * (from.time + to.time));
  if (middle.value <= 0 && from.value > 0) {
    const auto value_at = [&](double time) { return point(problem, step, guard, time).value; };
    return locate_sign_change(value_at, from.time, from.value, middle.time, middle.value,
                              epsilon * middle.time);
  }
  if (const auto first = search(problem, step, guard, from, middle, depth + 1)) return first;
  return search(problem, step, guard, middle, to, depth + 1);
}

std::optional<HiddenCrossing> Certificate::examine(const Problem& problem, const Step& step) {
  evaluate(problem, step.after, next_value_, next_rate_);
  std::optional<HiddenCrossing> first;
  bisections_ = 0;
  const auto crossings = problem.crossings();
  for (Index i = 0; i < problem.guard_count(); ++i) {
    if (crossings[i] == Crossing::none) continue;
    const double sign = side(crossings[i]);
    const GuardPoint from{step.start, sign * value_[i], sign * rate_[i]};
    const GuardPoint to{step.end, sign * next_value_[i], sign * next_rate_[i]};
    if (keeps_side(from, to)) continue;
    if (const auto time = search(problem, step, i, from, to, 0); time && (!first || *time < first->time))
      first = {i, *time};
  }
  value_.swap(next_value_);
  rate_.swap(next_rate_);
  return first;
}

}  // namespace mariotte::flow
