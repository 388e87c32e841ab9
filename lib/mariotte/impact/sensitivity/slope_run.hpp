// A run with slopes. Between events they follow the variational equation; at an event of guard γ
//
//     τ_p = −(γ_x S⁻ + γ_p)/γ̇,    S⁺ = S⁻ + (f⁻ − f⁺) τ_p
//
// where τ_p is the slope of its time [Aizerman & Gantmacher 1958; Hiskens & Pai 2000]. S is at fixed time.
// Guards of one instant move the state one after the other; to first order their order does not matter, since
// the state is continuous and each changes the rates by its own force.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/sensitivity/phase_slopes.hpp"

namespace mariotte::impact {

/// An event whose slopes are large, or that has none.
struct DelicateEvent {
  double time;   ///< dimensionless
  Index guard;   ///< that crosses slowly
  double speed;  ///< at which it crosses, relative to the natural one
};

/// Guards that have crossed at one instant, whose times move differently.
struct CoincidentEvents {
  double time;
  Index first, second;  ///< two of the guards
};

/// Where a run ended and how that moves, dimensionless.
template <class System>
struct SlopeRun {
  hybrid::Trajectory<typename System::Change> run;
  typename System::Mode mode;
  SlopeMatrix slopes;                     ///< of the final state at fixed time
  std::vector<double> rate;               ///< f at the end
  std::vector<double> time;               ///< slopes of the time of the ending
  std::vector<bool> time_is_shared;       ///< by parameter: guards that ended the run move apart in time
  bool time_is_noise = false;             ///< what ended the run is within the noise, and no guard
  std::optional<DelicateEvent> delicate;  ///< the slowest
  std::vector<CoincidentEvents> coincident;
};

/// `System` with its mode and `Variation`, which gives f_p and γ_p and is told what contacts remember.
/// `watch` is called at every step.
template <class System, class Variation>
class SlopeLoop {
 public:
  SlopeLoop(System& system, Variation& variation, const hybrid::Options& options,
            const std::function<void()>& watch)
      : system_(system), variation_(variation), options_(options), watch_(watch) {}

  SlopeRun<System> follow(ConstState x0, const SlopeMatrix& start);

 private:
  using Observer = PhaseSlopes<Variation, typename System::Mode>;

  void start_events(Observer& observer, SlopeRun<System>& result);
  void pass(Observer& observer, const typename System::Mode& before, ConstState rate,
            SlopeRun<System>& result);
  std::vector<double> time_slopes(const Observer& observer, Index guard, ConstState rate, double time,
                                  SlopeRun<System>& result);
  std::vector<double> rates(typename System::Mode& mode) {
    std::vector<double> dx(workspace_.run.state.size());
    system_.problem(mode).derivative(workspace_.run.state, dx);
    return dx;
  }

  /// True if the times of two events of one instant move apart.
  static bool note_difference(std::span<const double> tau, SlopeRun<System>& result) {
    bool any = false;
    for (std::size_t c = 0; c < tau.size(); ++c) {
      const double first = result.time[c];
      if (!(std::abs(tau[c] - first) > 1e-9 * (std::abs(tau[c]) + std::abs(first)))) continue;
      any = result.time_is_shared[c] = true;
    }
    return any;
  }

  System& system_;
  Variation& variation_;
  hybrid::Options options_;
  const std::function<void()>& watch_;
  hybrid::Workspace<System> workspace_;
};

template <class System, class Variation>
std::vector<double> SlopeLoop<System, Variation>::time_slopes(const Observer& observer, Index guard,
                                                              ConstState rate, double time,
                                                              SlopeRun<System>& result) {
  const auto& problem = system_.problem(workspace_.mode);
  const auto& x = workspace_.run.state;
  const auto along = [&](ConstState dx) {
    return variation_.guard_rate(problem, guard, x, dx, workspace_.mode);
  };
  std::vector<double> slopes(variation_.columns());
  const double crossing = along(rate);
  variation_.guard_slopes(guard, x, workspace_.mode, slopes);
  for (Index c = 0; c < variation_.columns(); ++c)
    slopes[c] = -(slopes[c] + along(observer.slopes.column(c))) / crossing;
  const double speed = variation_.crossing_speed(guard, crossing);
  constexpr double slow = 1e-6;  // errors of the run, 1e-12 of it, then are no more than its square
  if (speed < slow && !(result.delicate && result.delicate->speed <= speed))
    result.delicate = DelicateEvent{time, guard, speed};
  return slopes;
}

/// Contacts that touch at the start close there: they would close later with a larger gap.
template <class System, class Variation>
void SlopeLoop<System, Variation>::start_events(Observer& observer, SlopeRun<System>& result) {
  auto closed = workspace_.mode;
  for (const Index guard : variation_.guards_at_start(closed, workspace_.run.state)) {
    auto open = closed;
    variation_.open_at_start(open, guard);
    const auto after = rates(closed);
    workspace_.mode = open;
    const auto before = rates(workspace_.mode);
    if (before == after) {  // no force jumps, however slowly it closes
      workspace_.mode = closed;
      continue;
    }
    const auto tau = time_slopes(observer, guard, before, 0, result);
    for (Index c = 0; c < variation_.columns(); ++c)
      for (std::size_t r = 0; r < before.size(); ++r)
        observer.slopes(r, c) += (before[r] - after[r]) * tau[c];
    workspace_.mode = closed;
  }
}

/// From S⁻ to S⁺ at the guards that have fired; the mode is still the one before them.
template <class System, class Variation>
void SlopeLoop<System, Variation>::pass(Observer& observer, const typename System::Mode& before,
                                        ConstState rate, SlopeRun<System>& result) {
  const auto& fired = workspace_.fired;
  result.time_is_noise = fired.empty();
  if (fired.empty()) return;
  auto& x = workspace_.run.state;
  const double time = result.run.time;
  auto after_all = observer.slopes;
  std::vector<typename System::Change> ignored;
  result.time.assign(variation_.columns(), 0.0);
  result.time_is_shared.assign(variation_.columns(), false);
  typename System::Mode last = before;
  system_.transition(last, fired, x, ignored);
  for (std::size_t k = 0; k < fired.size(); ++k) {
    workspace_.mode = before;
    const auto tau = time_slopes(observer, fired[k], rate, time, result);
    if (k == 0)
      result.time = tau;
    else if (note_difference(tau, result))
      result.coincident.push_back({time, fired[0], fired[k]});
    auto mode = last;
    if (fired.size() > 1) {
      mode = before;
      system_.transition(mode, {fired[k]}, x, ignored);
    }
    const auto next = rates(mode);
    for (Index c = 0; c < variation_.columns(); ++c)
      for (std::size_t r = 0; r < next.size(); ++r)
        if (const double jump = rate[r] - next[r]; jump != 0) after_all(r, c) += jump * tau[c];
    variation_.remember(fired[k], before, mode, observer.slopes, rate, tau);
  }
  observer.slopes = after_all;
  workspace_.mode = before;
}

template <class System, class Variation>
SlopeRun<System> SlopeLoop<System, Variation>::follow(ConstState x0, const SlopeMatrix& start) {
  using hybrid::Ending;
  SlopeRun<System> result;
  auto& mode = workspace_.mode;
  auto& changes = workspace_.changes;
  const auto& fired = workspace_.fired;
  auto& run = workspace_.run;
  run.state.assign(x0.begin(), x0.end());
  result.time.assign(variation_.columns(), 0.0);
  result.time_is_shared.assign(variation_.columns(), false);
  CompensatedSum time;
  const auto end = [&](Ending ending, std::string message = {}) {
    result.run.ending = ending;
    result.run.message = std::move(message);
    result.run.time = time.value();
    result.run.state = run.state;
    result.mode = mode;
    result.rate = rates(mode);
  };

  system_.mode_at(run.state, mode, changes);
  Observer observer(system_.problem(mode), variation_, mode, options_.accuracy, watch_);
  observer.slopes = start;
  start_events(observer, result);
  for (;;) {
    hybrid::record(result.run, time.value(), changes);
    if (system_.is_over(mode, run.state, result.run.events > 0)) {
      system_.finish(mode, changes);
      hybrid::record(result.run, time.value(), changes);
      end(system_.ending(mode));
      break;
    }
    if (result.run.events >= options_.max_events) {
      end(Ending::event_limit);
      break;
    }
    observer.end_phase();
    const auto arrival =  // its observer never gives it up
        hybrid::follow_phase(system_, options_, workspace_, time, &observer).value();
    if (arrival.outcome != flow::Outcome::guard) {
      if (arrival.outcome == flow::Outcome::limit) {
        result.time.assign(variation_.columns(), 0.0);
        result.time_is_noise = false;
        result.time_is_shared.assign(variation_.columns(), false);
        end(Ending::time_limit);
      } else {
        end(arrival.outcome == flow::Outcome::never ? Ending::separated : Ending::failed, arrival.message);
      }
      break;
    }
    result.run.time = time.value();
    const auto before = mode;
    for (const Index guard : fired) variation_.settle(guard, before, run.state);
    pass(observer, before, rates(mode), result);
    system_.transition(mode, fired, run.state, changes);
  }
  result.run.flows = run.flows;
  result.slopes = std::move(observer.slopes);
  return result;
}

}  // namespace mariotte::impact
