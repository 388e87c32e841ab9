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

  void prepare(ConstState x0, SlopeRun<System>& result);
  void begin(Observer& observer, const SlopeMatrix& start, SlopeRun<System>& result);
  void start_events(Observer& observer, SlopeRun<System>& result);
  bool is_over(SlopeRun<System>& result);
  flow::Arrival follow_phase(Observer& observer);
  void stop(const flow::Arrival& arrival, SlopeRun<System>& result);
  void end(hybrid::Ending ending, const std::string& message, SlopeRun<System>& result);
  void pass_event(Observer& observer, SlopeRun<System>& result);
  void take_slopes(Observer& observer, SlopeRun<System>& result);
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
  CompensatedSum time_;
  std::vector<Index> telling_;  ///< guards that tell when the event happens
  std::vector<double> shift_;   ///< Σ τ_p by parameter, where events reset
  std::vector<double> reach_;   ///< largest slopes at an event by parameter
};

}  // namespace mariotte::impact

// the members of the template
#include "mariotte/impact/sensitivity/slope_events.hpp"
#include "mariotte/impact/sensitivity/slope_follow.hpp"
