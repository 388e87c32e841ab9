// The driver of flows that follow a phase by one power series after the other.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/roots/polynomial.hpp"

namespace mariotte::flow {

/// Share of the accuracy that the last terms of a step may spend: a phase takes about ten steps.
inline constexpr double series_share = 0.1;

/// Order that costs least at an accuracy; measured on the reference bodies.
inline int series_order(double accuracy) {
  if (accuracy > 1e-5) return 10;
  if (accuracy > 3e-8) return 14;
  return accuracy > 3e-12 ? 18 : 22;
}

/// Last coefficients that bound a step: next to where a contact begins only one in five is much more than
/// zero.
inline constexpr int last_terms = 2, last_onset_terms = 5;
/// Whether a step in a contact's own clock begins there, or so soon after that most of the pace of the clock
/// is still to come.
inline bool begins_at_onset(std::span<const double> time, double step) {
  return time[1] < 0.4 * time[2] * step;
}

/// xᵏ, k ≥ 1.
inline double to_the(double x, int k) {
  const double half = k > 1 ? to_the(x, k / 2) : 1;
  return half * half * (k % 2 == 1 ? x : 1);
}

/// Largest place at which none of the last terms of series exceeds `most`; size(k) is the largest coefficient
/// k. Most often the first of them decides, and the others take no root.
template <class Size>
double reach_of_last(std::span<const double> time, int order, double most, Size&& size) {
  double reach = infinity;
  const auto bound = [&](int first, int last) {
    for (int k = first; k <= last; ++k) {
      const double now = size(k);
      if (now * to_the(reach, k) > most) reach = std::pow(most / now, 1.0 / k);
    }
  };
  bound(order - last_terms + 1, order);
  if (begins_at_onset(time, reach)) bound(order - last_onset_terms + 1, order - last_terms);
  return reach;
}

/// Where a step ends in the clock of its series, and the guard that ends it.
struct SeriesEnd {
  double place;
  Index guard = -1;
};

/// What may be left of a phase after so many steps, or so many in a row that get nowhere, is stiff. Where
/// another flow has begun with no longer steps, it is not, and may take so many times as many.
struct SeriesLimits {
  Index steps, stalled;
};
inline constexpr Index series_patience = 100;

/// A step of an expansion, with `time` and `state` as below.
template <class Expansion>
class SeriesStep final : public Step {
 public:
  explicit SeriesStep(const Expansion& expansion) : expansion_(expansion) {}
  void at(double t, State x) const override {
    const bool last = !(t < end);  // the end, less the start, may be longer by rounding
    expansion_.state(last ? place_ : rise_to(expansion_.time(), t - start, place_), before, x);
  }
  void inside(double fraction, State x) const override { expansion_.state(fraction * place_, before, x); }
  bool forces(std::vector<ForceSeries>& list) const override {
    list.clear();
    if constexpr (requires { expansion_.add_forces(place_, list); }) {
      expansion_.add_forces(place_, list);
      return true;
    }
    return false;
  }
  /// On to the next step, of this duration and place of the clock.
  void go_on(double duration, double place, ConstState from, ConstState to) {
    start = std::exchange(end, end + duration);
    place_ = place;
    before = from;
    after = to;
  }

 private:
  const Expansion& expansion_;
  double place_ = 0;
};

/// How far a first step goes. Guards that begin with less than the accuracy of their change begin at zero:
/// that is their change in some natural times, not in a long flight. Steps of pressed contacts are shorter.
template <class Expansion>
double first_reach(const Expansion& expansion, double reach) {
  constexpr double natural_times = 4;
  if constexpr (requires { expansion.natural_time(); }) {
    const double most = natural_times * expansion.natural_time();
    if (horner(expansion.time(), reach) > most) return rise_to(expansion.time(), most, reach);
  }
  return reach;
}

inline bool is_finite(ConstState x) {
  return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
}

/// Follow a phase until a guard, the limit or what the expansion cannot pass (`stiff`), on from where another
/// expansion has come `so_far`. An expansion has
///   before                    room for the state where the step begins;
///   expand(x, first)          from x, in the first step or a later one: how far the series is good enough;
///   end(reach, first, x)      where the step ends; x is room for states;
///   time(), state(place, …)   the clock, and the state at a place of it;
///   fire(guard, x, fired)     where a guard ends the phase;
///   add_forces(end, list)     if it knows forces: those of closed contacts;
///   natural_time()            if its guards may begin with the accuracy of their change;
///   is_stalled(step), order().
template <class Expansion>
Arrival follow_by_series(Expansion& expansion, const SeriesLimits& limits, State x, const Request& request,
                         std::vector<Index>& fired, const Arrival& so_far = {}) {
  SeriesStep<Expansion> step(expansion);
  step.end = so_far.duration;
  const Index most = request.patient ? series_patience * limits.steps : limits.steps;
  Index count = 0, stalled = 0;
  const auto arrive = [&](Outcome outcome) {
    return Arrival{outcome, step.end, so_far.steps + count, so_far.rhs + count * expansion.order()};
  };
  while (count < most && stalled < limits.stalled) {
    const bool first = count++ == 0;
    expansion.before.assign(x.begin(), x.end());
    double reach = expansion.expand(x, first);
    if (!std::isfinite(reach)) return arrive(Outcome::stiff);
    if (first) reach = first_reach(expansion, reach);
    SeriesEnd end = expansion.end(reach, first, x);
    double duration = horner(expansion.time(), end.place);
    const bool limited = step.end + duration >= request.limit;
    if (limited) {
      duration = request.limit - step.end;
      end = {rise_to(expansion.time(), duration, end.place)};
    }
    expansion.state(end.place, expansion.before, x);
    if (!is_finite(x) || !(duration >= 0 && std::isfinite(duration))) {
      std::ranges::copy(expansion.before, x.begin());
      return arrive(Outcome::stiff);
    }
    if (end.guard >= 0) expansion.fire(end.guard, x, fired);
    step.go_on(duration, end.place, expansion.before, x);
    if (limited) step.end = request.limit;
    if (request.observer) request.observer->observe(step);
    if (limited || end.guard >= 0) return arrive(limited ? Outcome::limit : Outcome::guard);
    stalled = expansion.is_stalled(step) ? stalled + 1 : 0;
  }
  auto arrival = arrive(Outcome::stiff);
  arrival.resumable = count == most && !request.patient;
  return arrival;
}

}  // namespace mariotte::flow
