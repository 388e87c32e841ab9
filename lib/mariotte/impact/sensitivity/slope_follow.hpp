// A run with slopes from its start to its end.
#pragma once
#include "mariotte/impact/sensitivity/slope_run.hpp"

namespace mariotte::impact {

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
void SlopeLoop<System, Variation>::prepare(ConstState x0, SlopeRun<System>& result) {
  const auto columns = variation_.columns();
  for (auto* list : {&result.time, &shift_, &reach_}) list->assign(columns, 0.0);
  result.time_is_shared.assign(columns, false);
  time_ = {};
  workspace_.run.state.assign(x0.begin(), x0.end());
  system_.mode_at(workspace_.run.state, workspace_.mode, workspace_.changes);
}

template <class System, class Variation>
void SlopeLoop<System, Variation>::begin(Observer& observer, const SlopeMatrix& start,
                                         SlopeRun<System>& result) {
  auto& state = workspace_.run.state;
  observer.slopes = with_rows(start, std::ssize(state));
  start_events(observer, result);
  if constexpr (resets) {
    variation_.start(workspace_.mode, state, observer.slopes);
    variation_.begin({}, workspace_.mode, state, observer.slopes);
  }
}

template <class System, class Variation>
void SlopeLoop<System, Variation>::end(hybrid::Ending ending, const std::string& message,
                                       SlopeRun<System>& result) {
  result.run.ending = ending;
  result.run.message = message;
  result.run.time = time_.value();
  result.run.state = workspace_.run.state;
  result.mode = workspace_.mode;
  result.rate = rates(workspace_.mode);
}

template <class System, class Variation>
bool SlopeLoop<System, Variation>::is_over(SlopeRun<System>& result) {
  auto& mode = workspace_.mode;
  auto& changes = workspace_.changes;
  hybrid::record(result.run, time_.value(), changes);
  if (system_.is_over(mode, workspace_.run.state, result.run.events > 0)) {
    system_.finish(mode, changes);
    hybrid::record(result.run, time_.value(), changes);
    end(system_.ending(mode), "", result);
    return true;
  }
  if (result.run.events < options_.max_events) return false;
  end(hybrid::Ending::event_limit, "", result);
  return true;
}

template <class System, class Variation>
flow::Arrival SlopeLoop<System, Variation>::follow_phase(Observer& observer) {
  observer.end_phase();
  if constexpr (resets) {
    system_.problem(workspace_.mode);
    observer.fit();
  }
  // its observer never gives it up
  return hybrid::follow_phase(system_, options_, workspace_, time_, &observer).value();
}

template <class System, class Variation>
void SlopeLoop<System, Variation>::stop(const flow::Arrival& arrival, SlopeRun<System>& result) {
  using hybrid::Ending;
  if (arrival.outcome != flow::Outcome::limit)
    return end(arrival.outcome == flow::Outcome::never ? Ending::separated : Ending::failed, arrival.message,
               result);
  result.time.assign(variation_.columns(), 0.0);
  result.time_is_shared.assign(variation_.columns(), false);
  result.time_is_noise = false;
  result.time_loss = 0;
  end(Ending::time_limit, "", result);
}

template <class System, class Variation>
void SlopeLoop<System, Variation>::pass_event(Observer& observer, SlopeRun<System>& result) {
  auto& state = workspace_.run.state;
  result.run.time = time_.value();
  const auto before = workspace_.mode;
  telling_ = telling(before);
  for (const Index guard : telling_) variation_.settle(guard, before, state);
  pass(observer, before, rates(workspace_.mode), result);
  note_reach(observer);
  system_.transition(workspace_.mode, workspace_.fired, state, workspace_.changes);
}

template <class System, class Variation>
void SlopeLoop<System, Variation>::take_slopes(Observer& observer, SlopeRun<System>& result) {
  constexpr double reserve = 1000;  // runs with slopes are a hundred times as exact as is asked
  const double unresolved = observer.unresolved();
  if (unresolved > reserve * options_.accuracy) result.unresolved = unresolved;
  for (Index c = 0; c < variation_.columns(); ++c)
    if (shift_[c] != 0)
      for (std::size_t r = 0; r < result.rate.size(); ++r)
        observer.slopes(r, c) -= result.rate[r] * shift_[c];
  result.slopes = std::move(observer.slopes);
  result.shrinkage = shrinkage(result.slopes);
}

template <class System, class Variation>
SlopeRun<System> SlopeLoop<System, Variation>::follow(ConstState x0, const SlopeMatrix& start) {
  SlopeRun<System> result;
  prepare(x0, result);
  auto& mode = workspace_.mode;
  Observer observer(system_.problem(mode), variation_, mode, resolution_, watch_);
  begin(observer, start, result);
  while (!is_over(result)) {
    const auto arrival = follow_phase(observer);
    if (arrival.outcome != flow::Outcome::guard) {
      stop(arrival, result);
      break;
    }
    pass_event(observer, result);
  }
  result.run.flows = workspace_.run.flows;
  take_slopes(observer, result);
  return result;
}

}  // namespace mariotte::impact
