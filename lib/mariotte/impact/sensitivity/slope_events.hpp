// What events do to slopes: their times move with the parameters, and rates jump there.
#pragma once
#include "mariotte/impact/sensitivity/slope_run.hpp"

namespace mariotte::impact {

/// At which a guard crosses, relative to the natural one.
template <class System, class Variation>
double SlopeLoop<System, Variation>::speed_of(Index guard, ConstState rate) {
  const auto& mode = workspace_.mode;
  const double crossing =
      variation_.guard_rate(system_.problem(workspace_.mode), guard, workspace_.run.state, rate, mode);
  return variation_.crossing_speed(guard, crossing, mode);
}

/// True of a guard that crosses fast enough: times of grazed ones have slopes so large that those of all that
/// moves would lose digits.
template <class System, class Variation>
bool SlopeLoop<System, Variation>::sets_clock(Index guard, ConstState rate) {
  constexpr double brisk = 1e-3;
  return speed_of(guard, rate) > brisk;
}

/// Slopes at fixed time since an event that moves by τ_p.
template <class System, class Variation>
void SlopeLoop<System, Variation>::shift_clock(Observer& observer, ConstState rate,
                                               const std::vector<double>& time) {
  for (Index c = 0; c < variation_.columns(); ++c) {
    shift_[c] += time[c];
    for (std::size_t r = 0; r < rate.size(); ++r) observer.slopes(r, c) += rate[r] * time[c];
  }
}

/// Of the time of a guard.
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

/// Slopes of the times of guards that have fired.
template <class System, class Variation>
std::vector<std::vector<double>> SlopeLoop<System, Variation>::event_times(const Observer& observer,
                                                                           const std::vector<Index>& guards,
                                                                           ConstState rate,
                                                                           SlopeRun<System>& result) {
  const double time = result.run.time;
  std::vector<std::vector<double>> times;
  result.time_is_shared.assign(variation_.columns(), false);
  for (const Index guard : guards) {
    times.push_back(time_slopes(observer, guard, rate, time, result));
    if (times.size() == 1) result.time = times[0];
    auto apart = difference(times[0], times.back());
    if (std::find(apart.begin(), apart.end(), true) == apart.end()) continue;
    for (std::size_t c = 0; c < apart.size(); ++c)
      if (apart[c]) result.time_is_shared[c] = true;
    result.coincident.push_back({time, variation_.name(guards[0], workspace_.mode),
                                 variation_.name(guard, workspace_.mode), std::move(apart)});
  }
  return times;
}

/// Guards that tell when what happens at one instant happens: where no flow has met them, as far as they
/// cross so fast that their time is no rounding.
template <class System, class Variation>
std::vector<Index> SlopeLoop<System, Variation>::telling(const typename System::Mode& before) {
  auto after = before;
  std::vector<typename System::Change> ignored;
  auto behind = workspace_.run.state;
  system_.transition(after, workspace_.fired, behind, ignored);
  auto guards = workspace_.fired;
  if constexpr (requires { variation_.telling(guards, before, after); })
    guards = variation_.telling(guards, before, after);
  if constexpr (requires { variation_.unmet(guards, before, after); })
    for (const Index guard : variation_.unmet(workspace_.fired, before, after))
      if (speed_of(guard, rates(workspace_.mode)) >= slow) guards.push_back(guard);
  return guards;
}

/// The place among guards that have fired of the one that sets the clock, if any does.
template <class System, class Variation>
std::optional<std::size_t> SlopeLoop<System, Variation>::clock_at(const std::vector<Index>& fired,
                                                                  const typename System::Mode& before,
                                                                  const typename System::Mode& after,
                                                                  ConstState rate) {
  for (std::size_t k = 0; k < fired.size(); ++k)
    if (variation_.closes(fired[k], before, after) &&
        (sets_clock(fired[k], rate) || variation_.is_free(before)))
      return k;
  return std::nullopt;
}

/// Of a state that goes on: each guard changes rates by its own force. By the clock of one guard
/// S⁺ + f⁺ τ is S⁻ + f⁻ τ, without what its force does in a time that may be long.
template <class System, class Variation>
void SlopeLoop<System, Variation>::jump(Observer& observer, const typename System::Mode& before,
                                        ConstState rate, SlopeRun<System>& result) {
  const auto& fired = telling_;
  const auto times = event_times(observer, fired, rate, result);
  for (Index c = 0; c < variation_.columns(); ++c) result.time[c] += shift_[c];
  auto& x = workspace_.run.state;
  auto after_all = observer.slopes;
  std::vector<typename System::Change> ignored;
  typename System::Mode last = before;
  system_.transition(last, workspace_.fired, x, ignored);
  const auto clock = clock_at(fired, before, last, rate);
  if constexpr (requires { typename Variation::Passage; })
    variation_.keep_opening({fired, before, last, x, rate, observer.slopes, times, shift_, result.run.time});
  double error = 0;
  for (std::size_t k = 0; k < fired.size(); ++k) {
    auto mode = last;
    if (fired.size() > 1) {
      mode = before;
      system_.transition(mode, {fired[k]}, x, ignored);
    }
    const auto next = rates(mode);
    if (jumps(rate, next)) error = infinity;
    if (k != clock && variation_.closes(fired[k], before, mode))
      error = std::max(error, variation_.lost_at_onset(fired[k]));
    for (Index c = 0; c < variation_.columns(); ++c)
      for (std::size_t r = 0; r < next.size(); ++r)
        if (const double jump = rate[r] - next[r]; jump != 0)
          after_all(r, c) += jump * (times[k][c] - (clock ? times[*clock][c] : 0));
    variation_.remember(fired[k], before, mode, observer.slopes, rate, times[k]);
  }
  observer.slopes = after_all;
  if constexpr (requires { variation_.come_to_rest(before, last, x, observer.slopes); })
    variation_.come_to_rest(before, last, x, observer.slopes);
  constexpr double least = 1e-13;  // nobody asks for less
  for (auto& one : result.coincident)
    if (one.time == result.run.time) one.error = error > std::max(least, options_.accuracy) ? error : 0;
  if (!clock) return;
  shift_clock(observer, rate, times[*clock]);
  if constexpr (requires { variation_.place_gap(fired[*clock], x, before, observer.slopes); })
    variation_.place_gap(fired[*clock], x, before, observer.slopes);
  if constexpr (requires { variation_.gap_reach(fired[*clock], observer.slopes); })
    for (const Index guard : fired)
      if (guard != fired[*clock] && variation_.closes(guard, before, last))
        result.onset_loss = std::max(result.onset_loss, variation_.gap_reach(guard, observer.slopes));
}

/// Of a state of which parts begin, end, or are told anew.
template <class System, class Variation>
void SlopeLoop<System, Variation>::reset(Observer& observer, const typename System::Mode& before,
                                         ConstState rate, SlopeRun<System>& result) {
  const auto& fired = workspace_.fired;
  const auto& x = workspace_.run.state;
  auto after = before;
  auto behind = x;
  std::vector<typename System::Change> ignored;
  system_.transition(after, fired, behind, ignored);
  const auto next = rates(after, behind);
  const auto& guards = telling_;
  if (guards.empty()) {
    system_.problem(workspace_.mode);
    return;
  }
  const auto times = event_times(observer, guards, rate, result);
  observer.slopes = variation_.pass({before, after, x, behind, rate, next, guards, times}, observer.slopes);
  shift_clock(observer, next, times[0]);
  variation_.begin(before, after, behind, observer.slopes);
  result.time = shift_;
  system_.problem(workspace_.mode);  // which transitions look at
}

/// A guard that crosses slowly makes much of the errors of a state.
template <class System, class Variation>
void SlopeLoop<System, Variation>::note_loss(ConstState rate, SlopeRun<System>& result) {
  result.time_loss = 0;
  if constexpr (!resets)
    for (const Index guard : workspace_.fired)
      result.time_loss = std::max(result.time_loss,
                                  variation_.natural_time(guard) / result.run.time / speed_of(guard, rate));
}

/// What is large on the way leaves its errors in what is small at the end.
template <class System, class Variation>
void SlopeLoop<System, Variation>::note_reach(const Observer& observer) {
  if constexpr (has_reach)
    for (Index c = 0; c < variation_.columns(); ++c)
      reach_[c] = std::max(reach_[c], variation_.reach(observer.slopes, c));
}

template <class System, class Variation>
double SlopeLoop<System, Variation>::shrinkage(const SlopeMatrix& slopes) const {
  double most = 1;
  if constexpr (has_reach)
    for (Index c = 0; c < variation_.columns(); ++c)
      most = std::max(most, reach_[c] / variation_.reach(slopes, c));
  return most;
}

/// From S⁻ to S⁺ at the guards that have fired; the mode is still the one before them.
template <class System, class Variation>
void SlopeLoop<System, Variation>::pass(Observer& observer, const typename System::Mode& before,
                                        ConstState rate, SlopeRun<System>& result) {
  result.time_is_noise = std::none_of(workspace_.fired.begin(), workspace_.fired.end(),
                                      [&](Index guard) { return has_time(guard); });
  if (!resets && workspace_.fired.empty()) return;
  note_loss(rate, result);
  if constexpr (resets)
    reset(observer, before, rate, result);
  else
    jump(observer, before, rate, result);
}

}  // namespace mariotte::impact
