// The event loop. x is continuous; t⁻ and t⁺ are the two sides of an event:
//
//   mode ← mode_at(x₀)                                  which contacts act at 0+
//   repeat
//     if is_over(mode, x)              → its ending     asked before the first flow, too
//     if events ≥ max_events           → event_limit
//     if whoever looks on gives it up  → interrupted    asked after every step, too
//     flow ← the cheapest that mode admits
//     follow it from t⁺ until a guard crosses, or max_time
//     if the phase is too stiff for it → from there on by another, or by itself if that takes no longer steps
//     if the flow could not go on, or a number is not finite
//                                      → from t⁺ by another, as long as there is one
//                                      → failed         state and events until then are kept
//                                                         likewise after an event that a flow has passed
//     if mode after mode ends at once  → failed         contacts that chatter without end
//     if the time limit came first     → time_limit
//     if no guard can ever cross       → separated
//     t ← t + duration                                  a compensated sum of local clocks
//     mode ← transition(mode, fired, x)                 the whole set that fired at t⁻
//     if there is no such mode         → failed
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mariotte/core/compensated.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/hybrid/system.hpp"
#include "mariotte/hybrid/trajectory.hpp"
#include "mariotte/hybrid/turns.hpp"

namespace mariotte::hybrid {

/// Times divided by those of a scale, and the accuracy of phases.
inline Options scaled(Options options, const Scale& scale) {
  options.max_time /= scale.time;
  options.accuracy = std::max(options.accuracy * scale.refinement, std::min(options.accuracy, 8 * epsilon));
  return options;
}

/// Told when a phase begins, so that a observer of steps knows its place on the absolute clock.
class PhaseObserver : public flow::StepObserver {
 public:
  virtual void begin_phase(double time, ConstState x) = 0;
  /// So many events have passed. May throw.
  virtual void passed(double /*time*/, Index /*events*/) {}
  /// True gives the run up. Asked after every event and every step.
  virtual bool gives_up() const { return false; }
};

/// Thrown out of a phase that is given up, with the end of its last step.
struct GivenUp {
  double duration;  ///< since the phase began
  std::vector<double> state;
};

/// Hands steps on, and asks after each whether the run goes on.
class AskingObserver final : public flow::StepObserver {
 public:
  explicit AskingObserver(PhaseObserver& observer) : observer_(observer) {}
  void observe(const flow::Step& step) override {
    observer_.observe(step);
    if (observer_.gives_up()) throw GivenUp{step.end, {step.after.begin(), step.after.end()}};
  }
  bool has_slopes() const override { return observer_.has_slopes(); }

 private:
  PhaseObserver& observer_;
};

/// Systems that change their mode within a phase:
///   opens_within(mode, guard, approach, changes)   as `transition`, if they do
template <class S>
concept OpensWithin = requires(S& system, typename S::Mode& mode, Index guard, double approach,
                               std::vector<typename S::Change>& changes) {
  { system.opens_within(mode, guard, approach, changes) } -> std::same_as<bool>;
};

/// What a run needs; kept from one run to the next, it allocates nothing after the first of its size.
template <HybridSystem System>
struct Workspace {
  flow::Flows flows;
  typename System::Mode mode;
  std::vector<typename System::Change> changes;
  std::vector<Index> fired;
  std::vector<double> before;                     ///< the state at the beginning of the phase
  Index most_steps = flow::Request::usual_steps;  ///< after which a phase is given up for its length
  bool passes_events = false;  ///< flows may go on after events, so that results differ by rounding
  Trajectory<typename System::Change> run;
};

/// Records events at which flows go on. Systems know none unless they open contacts within a phase.
template <HybridSystem System>
class RecordingTaker final : public flow::EventTaker {
 public:
  /// For phases that begin at a time; all must live as long.
  RecordingTaker(System& system, const Options& options, Workspace<System>& workspace,
                 const CompensatedSum& began)
      : system_(system), options_(options), workspace_(workspace), began_(began) {}

  bool take(Index guard, double time, double rate) override {
    if constexpr (OpensWithin<System>) {
      auto& run = workspace_.run;
      auto& changes = workspace_.changes;
      if (run.events + 1 >= options_.max_events) return false;
      if (!system_.opens_within(workspace_.mode, guard, rate, changes)) return false;
      auto now = began_;
      now += time;
      record(run, now.value(), changes);
      return has_taken_ = true;
    }
    return false;
  }
  /// The mode is no longer that of the beginning of the phase.
  bool has_taken() const { return has_taken_; }

 private:
  System& system_;
  const Options& options_;
  Workspace<System>& workspace_;
  const CompensatedSum& began_;
  bool has_taken_ = false;
};

/// What is not finite must not pass for a result.
inline void refuse_overflow(flow::Arrival& arrival, ConstState x) {
  const bool ends = arrival.outcome == flow::Outcome::guard || arrival.outcome == flow::Outcome::limit;
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!ends || (std::isfinite(arrival.duration) && std::all_of(x.begin(), x.end(), finite))) return;
  arrival.outcome = flow::Outcome::failed;
  arrival.message = "a number is not finite";
}

/// Follow the present phase to its end, by one flow or, where that gives up, by those that may take over.
/// Nothing if whoever looks on gives the run up; state and time are then those of the last step.
template <HybridSystem System>
std::optional<flow::Arrival> follow_phase(System& system, const Options& options,
                                          Workspace<System>& workspace, CompensatedSum& time,
                                          PhaseObserver* observer) {
  auto& [flows, mode, changes, fired, before, most_steps, passes_events, run] = workspace;
  auto& x = run.state;
  RecordingTaker<System> taker(system, options, workspace, time);
  auto& problem = system.problem(mode);
  Turns turns(flows, problem, options.flow, most_steps);
  std::optional<AskingObserver> asking;
  if (observer) asking.emplace(*observer);
  for (;;) try {
      if (observer) observer->begin_phase(time.value(), x);
      fired.clear();
      before.assign(x.begin(), x.end());
      const auto request = turns.asking({.limit = options.max_time - time.value(),
                                         .accuracy = options.accuracy,
                                         .observer = asking ? &*asking : nullptr,
                                         .events = passes_events ? &taker : nullptr});
      auto arrival = turns.flow().follow(problem, x, request, fired);
      refuse_overflow(arrival, x);
      count(run.flows[static_cast<std::size_t>(turns.kind())], arrival);
      const bool stiff = arrival.outcome == flow::Outcome::stiff;
      const bool failed = arrival.outcome == flow::Outcome::failed;
      if (!failed) time += arrival.duration;
      if (!stiff && !failed) most_steps = turns.most_steps(arrival);
      if ((!stiff && !failed) || (failed && taker.has_taken())) return arrival;
      if (failed) x.assign(before.begin(), before.end());
      if (!turns.pass_on(arrival)) return arrival;
    } catch (GivenUp& last) {
      x = std::move(last.state);
      time += last.duration;
      return {};
    }
}

/// So many modes in turn that end at the instant at which they begin, or within rounding of it without a
/// change, will go on to do so.
inline constexpr Index most_at_once = 10000;

/// Run a system from state x until an ending; the result stays in the workspace. Options are in the system's
/// scales; `observer` may be null.
template <HybridSystem System>
const Trajectory<typename System::Change>& simulate(System& system, ConstState x0, const Options& options,
                                                    Workspace<System>& workspace,
                                                    PhaseObserver* observer = nullptr) {
  auto& mode = workspace.mode;
  auto& changes = workspace.changes;
  auto& run = workspace.run;
  clear(run);
  changes.clear();
  auto& x = run.state;
  x.assign(x0.begin(), x0.end());
  workspace.most_steps = flow::Request::usual_steps;
  CompensatedSum time;
  Index at_once = 0;
  const auto end = [&](Ending ending, std::string message = {}) -> const auto& {
    run.ending = ending;
    run.message = std::move(message);
    run.time = time.value();
    return run;
  };

  system.mode_at(x, mode, changes);
  for (;;) {
    record(run, time.value(), changes);
    if (observer) observer->passed(time.value(), run.events);
    if (system.is_over(mode, x, run.events > 0)) {
      system.finish(mode, changes);
      record(run, time.value(), changes);
      return end(system.ending(mode));
    }
    if (run.events >= options.max_events) return end(Ending::event_limit);
    if (observer && observer->gives_up()) return end(Ending::interrupted);

    const double began = time.value();
    auto arrival = follow_phase(system, options, workspace, time, observer);
    if (!arrival) return end(Ending::interrupted);
    if (arrival->outcome == flow::Outcome::limit) return end(Ending::time_limit);
    if (arrival->outcome == flow::Outcome::never) return end(Ending::separated);
    if (arrival->outcome == flow::Outcome::failed) return end(Ending::failed, std::move(arrival->message));
    if (at_once > most_at_once) return end(Ending::failed, "contacts change without end at one instant");
    try {
      system.transition(mode, workspace.fired, x, changes);
    } catch (const Error& impasse) {
      record(run, time.value(), changes);
      return end(Ending::failed, impasse.what());
    }
    const bool is_idle = changes.empty() && arrival->duration <= epsilon * time.value();
    at_once = time.value() > began && !is_idle ? 0 : at_once + 1;
  }
}

}  // namespace mariotte::hybrid
