// A run with slopes. Between events they follow the variational equation; at an event of guard γ
//
//     τ_p = −(γ_x S⁻ + γ_p)/γ̇,    S⁺ = S⁻ + (f⁻ − f⁺) τ_p
//
// where τ_p is the slope of its time [Aizerman & Gantmacher 1958; Hiskens & Pai 2000]. S is at fixed time.
// Guards of one instant move the state one after the other; to first order their order does not matter, since
// the state is continuous and each changes the rates by its own force.
//
// From a contact that closes on, slopes are carried at fixed time since that instant instead, S + f Σ τ_p,
// which follows the same equation: the slope of its gap is zero then, and no root of its force is met with
// another slope. One that closes slowly does so only while no other pushes. Where events begin and end what
// is integrated, all events set the clock so.
#pragma once
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/sensitivity/parameter.hpp"
#include "mariotte/impact/sensitivity/phase_slopes.hpp"

namespace mariotte::impact {

/// An event that crosses slowly: slopes behind it are large, or there are none.
struct DelicateEvent {
  double time;       ///< dimensionless
  std::string what;  ///< crosses slowly
  double speed;      ///< at which it crosses, relative to the natural one
};

/// Guards that have crossed at one instant, whose times move differently.
struct CoincidentEvents {
  double time;
  std::string first, second;  ///< whose guards they are, of two of them
  std::vector<bool> apart;    ///< by parameter: moves them apart
  /// By how much of their size slopes may be off: infinite where forces jump, so that they depend on which
  /// comes first.
  double error = infinity;
};

/// Where a run ended and how that moves, dimensionless.
template <class System>
struct SlopeRun {
  hybrid::Trajectory<typename System::Change> run;
  typename System::Mode mode;
  SlopeMatrix slopes;                ///< of the final state at fixed time
  std::vector<double> rate;          ///< f at the end
  std::vector<double> time;          ///< slopes of the time of the ending
  std::vector<bool> time_is_shared;  ///< by parameter: guards that ended the run move apart in time
  bool time_is_noise = false;        ///< what ended the run is within the noise
  double time_loss = 0;              ///< error of the time's slopes over that of the state's
  double onset_loss = 0;             ///< the same of slopes behind contacts that close by another's clock
  double shrinkage = 1;              ///< slopes at an event over those at the end
  std::vector<DelicateEvent> delicate;
  std::vector<CoincidentEvents> coincident;
  double unresolved = 0;  ///< error beyond what is asked, relative to the slopes
};

/// What a time limit has ended ends later with the limit, which is in units of `time`.
template <class System, class Model>
void move_limit(const std::vector<Parameter<Model>>& by, double time, SlopeRun<System>& end) {
  if (end.run.ending != hybrid::Ending::time_limit) return;
  for (std::size_t c = 0; c < by.size(); ++c) end.time[c] = by[c].limit / time;
}

/// `System` with its mode and `Variation`, which gives f_p and γ_p and is told what contacts remember.
/// `watch` is called at every step.
template <class System, class Variation>
class SlopeLoop {
 public:
  SlopeLoop(System& system, Variation& variation, const hybrid::Options& options,
            const std::function<void()>& watch)
      : SlopeLoop(system, variation, options, options.accuracy, watch) {}
  /// `resolution` of steps that may be finer than the accuracy of the run.
  SlopeLoop(System& system, Variation& variation, const hybrid::Options& options, double resolution,
            const std::function<void()>& watch)
      : system_(system), variation_(variation), options_(options), resolution_(resolution), watch_(watch) {}

  SlopeRun<System> follow(ConstState x0, const SlopeMatrix& start);

 private:
  using Observer = PhaseSlopes<Variation, typename System::Mode>;

  void start_events(Observer& observer, SlopeRun<System>& result);
  void pass(Observer& observer, const typename System::Mode& before, ConstState rate,
            SlopeRun<System>& result);
  std::vector<std::vector<double>> event_times(const Observer& observer, const std::vector<Index>& guards,
                                               ConstState rate, SlopeRun<System>& result);
  void note_loss(ConstState rate, SlopeRun<System>& result);
  void note_reach(const Observer& observer);
  double shrinkage(const SlopeMatrix& slopes) const;
  void jump(Observer& observer, const typename System::Mode& before, ConstState rate,
            SlopeRun<System>& result);
  double speed_of(Index guard, ConstState rate);
  bool sets_clock(Index guard, ConstState rate);
  std::vector<Index> telling(const typename System::Mode& before);
  std::optional<std::size_t> clock_at(const std::vector<Index>& fired, const typename System::Mode& before,
                                      const typename System::Mode& after, ConstState rate);
  void shift_clock(Observer& observer, ConstState rate, const std::vector<double>& time);
  void reset(Observer& observer, const typename System::Mode& before, ConstState rate,
             SlopeRun<System>& result);
  std::vector<double> time_slopes(const Observer& observer, Index guard, ConstState rate, double time,
                                  SlopeRun<System>& result);
  std::vector<double> rates(typename System::Mode& mode, ConstState x) {
    std::vector<double> dx(x.size());
    system_.problem(mode).derivative(x, dx);
    return dx;
  }
  std::vector<double> rates(typename System::Mode& mode) { return rates(mode, workspace_.run.state); }
  /// Speed of a guard at which errors of the run, 1e-12 of it, are no more than its square.
  static constexpr double slow = 1e-6;
  /// Whether events begin and end what is integrated.
  static constexpr bool resets = requires(const Variation& variation, const typename System::Mode& mode) {
    variation.contact_of(Index{}, mode);
  };

  /// Whether it is told how large slopes are.
  static constexpr bool has_reach = requires(const Variation& variation, const SlopeMatrix& slopes) {
    variation.reach(slopes, Index{});
  };

  /// Whether the time of a guard follows from numbers of the scene.
  bool has_time(Index guard) const {
    if constexpr (requires { variation_.has_time(guard, workspace_.mode); })
      return variation_.has_time(guard, workspace_.mode);
    return true;
  }

  /// By parameter: the times of two events of one instant move apart.
  static std::vector<bool> difference(const std::vector<double>& first, const std::vector<double>& second) {
    std::vector<bool> apart;
    for (std::size_t c = 0; c < first.size(); ++c) {
      const double size = std::abs(first[c]) + std::abs(second[c]);
      apart.push_back(std::abs(second[c] - first[c]) > 1e-9 * size);
    }
    return apart;
  }
  /// Beyond rounding.
  static bool jumps(std::span<const double> before, std::span<const double> after) {
    double most = 0, size = 0;
    for (std::size_t r = 0; r < before.size(); ++r) {
      most = std::max(most, std::abs(before[r] - after[r]));
      size = std::max(size, std::abs(before[r]));
    }
    return most > 1e-9 * size;
  }

  System& system_;
  Variation& variation_;
  hybrid::Options options_;
  double resolution_;
  const std::function<void()>& watch_;
  hybrid::Workspace<System> workspace_;
  std::vector<Index> telling_;  ///< guards that tell when the event happens
  std::vector<double> shift_;   ///< Σ τ_p by parameter, where events reset
  std::vector<double> reach_;   ///< largest slopes at an event by parameter
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
  std::vector<double> slopes(variation_.columns(), 0.0);
  if (!has_time(guard)) return slopes;
  const double crossing = along(rate);
  variation_.guard_slopes(guard, x, workspace_.mode, slopes);
  for (Index c = 0; c < variation_.columns(); ++c)
    slopes[c] = -(slopes[c] + along(observer.slopes.column(c))) / crossing;
  const double speed = variation_.crossing_speed(guard, crossing, workspace_.mode);
  if (speed < slow) result.delicate.push_back({time, variation_.name(guard, workspace_.mode), speed});
  return slopes;
}

/// Contacts that touch at the start close there: they would close later with a larger gap.
template <class System, class Variation>
void SlopeLoop<System, Variation>::start_events(Observer& observer, SlopeRun<System>& result) {
  auto closed = workspace_.mode;
  bool first = true;
  for (const Index guard : variation_.guards_at_start(closed, workspace_.run.state)) {
    auto open = closed;
    variation_.open_at_start(open, guard);
    const auto after = rates(closed);
    workspace_.mode = open;
    const auto before = rates(workspace_.mode);
    if (!resets && before == after &&
        !sets_clock(guard, before)) {  // no force jumps, however slowly it closes
      workspace_.mode = closed;
      continue;
    }
    const auto tau = time_slopes(observer, guard, before, 0, result);
    for (Index c = 0; c < variation_.columns(); ++c)
      for (std::size_t r = 0; r < before.size(); ++r)
        observer.slopes(r, c) += (before[r] - after[r]) * tau[c];
    const bool sets = sets_clock(guard, before);
    workspace_.mode = closed;
    if (first && (resets || sets)) shift_clock(observer, after, tau);
    first = false;
  }
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
  shift_.assign(variation_.columns(), 0.0);
  reach_.assign(variation_.columns(), 0.0);
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
  Observer observer(system_.problem(mode), variation_, mode, resolution_, watch_);
  observer.slopes = with_rows(start, std::ssize(run.state));
  start_events(observer, result);
  if constexpr (resets) {
    variation_.start(mode, run.state, observer.slopes);
    variation_.begin({}, mode, run.state, observer.slopes);
  }
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
    if constexpr (resets) {
      system_.problem(mode);
      observer.fit();
    }
    const auto arrival =  // its observer never gives it up
        hybrid::follow_phase(system_, options_, workspace_, time, &observer).value();
    if (arrival.outcome != flow::Outcome::guard) {
      if (arrival.outcome == flow::Outcome::limit) {
        result.time.assign(variation_.columns(), 0.0);
        result.time_is_noise = false;
        result.time_loss = 0;
        result.time_is_shared.assign(variation_.columns(), false);
        end(Ending::time_limit);
      } else {
        end(arrival.outcome == flow::Outcome::never ? Ending::separated : Ending::failed, arrival.message);
      }
      break;
    }
    result.run.time = time.value();
    const auto before = mode;
    telling_ = telling(before);
    for (const Index guard : telling_) variation_.settle(guard, before, run.state);
    pass(observer, before, rates(mode), result);
    note_reach(observer);
    system_.transition(mode, fired, run.state, changes);
  }
  result.run.flows = run.flows;
  constexpr double reserve = 1000;  // runs with slopes are a hundred times as exact as is asked
  const double unresolved = observer.unresolved();
  if (unresolved > reserve * options_.accuracy) result.unresolved = unresolved;
  for (Index c = 0; c < variation_.columns(); ++c)
    if (shift_[c] != 0)
      for (std::size_t r = 0; r < result.rate.size(); ++r)
        observer.slopes(r, c) -= result.rate[r] * shift_[c];
  result.slopes = std::move(observer.slopes);
  result.shrinkage = shrinkage(result.slopes);
  return result;
}

}  // namespace mariotte::impact

#include "mariotte/impact/sensitivity/slope_events.hpp"  // the other members of the template
