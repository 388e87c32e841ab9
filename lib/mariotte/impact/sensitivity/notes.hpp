// What is to be said of slopes that are large, one-sided or missing.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/slope_run.hpp"

namespace mariotte::impact {

using Names = std::vector<std::string>;

/// Names of parameters, of those for which `is_one` is true; empty if that is none.
template <class IsOne>
Names names_of(const std::vector<ParameterValue>& parameters, IsOne&& is_one) {
  Names names;
  for (std::size_t c = 0; c < parameters.size(); ++c)
    if (is_one(c)) names.push_back(parameters[c].name);
  return names;
}

/// Of `outcomes`: "contact 2 crosses at 1.2e-05 of the natural speed at 3.5 s: …".
SlopeNote grazing_note(const DelicateEvent& event, double unit, Names outcomes);
/// By `parameters`.
SlopeNote coincidence_note(const CoincidentEvents& events, double unit, Names outcomes, Names parameters);
SlopeNote near_closing_note(const std::string& what, double speed, Names outcomes, Names parameters);
SlopeNote closing_in_noise_note(const std::string& what, Names pushed);
SlopeNote hardly_touching_note(const std::string& what, double speed, Names parameters);
SlopeNote near_yield_note(const std::string& what, double depth);
SlopeNote near_miss_note(const std::string& what, double gap);
SlopeNote slip_from_rest_note();
SlopeNote unknown_way_note();
SlopeNote turning_slip_note(double error);
SlopeNote shared_onset_note(double error);
SlopeNote shrinking_note(double error);
SlopeNote growing_note(double error);
SlopeNote shared_ending_note(Names outcomes, Names parameters);
SlopeNote noise_ending_note(Names outcomes);
SlopeNote slow_ending_note(double error, Names outcomes);
SlopeNote waiting_note(Names parameters);
SlopeNote unresolved_note(double error);
SlopeNote long_way_note(double error);
SlopeNote faded_spring_note(Names outcomes);
SlopeNote fading_spring_note(double error, Names outcomes);
/// Slopes that are no numbers are left out; a note says so.
void leave_out_unbounded(Sensitivity& slopes);
/// Throws InvalidParameter for more slopes than memory and patience allow.
void expect_few(Index components, Index parameters);

/// Of a contact that closes without slip and slips; `moved` are parameters that give it one.
void add_note_of_landing(const std::vector<bool>& moved, Sensitivity& result);

/// Add a note of an error. Slopes that may be off by more than a tenth tell nothing, and are left out.
void add_doubt(SlopeNote note, Sensitivity& result);

/// Of the events that cross slowly, the slowest during the run or at its end.
template <class System>
void add_slowest(const SlopeRun<System>& end, bool is_end, double unit, const Names& ending,
                 Sensitivity& result) {
  const DelicateEvent* slowest = nullptr;
  for (const auto& one : end.delicate)
    if ((one.time == end.run.time) == is_end && !(slowest && slowest->speed <= one.speed)) slowest = &one;
  if (slowest) result.notes.push_back(grazing_note(*slowest, unit, is_end ? ending : Names{}));
}

/// Notes of a run; `unit` is that of time [s], `ending` are the outcomes that move with the time of the
/// ending.
template <class System>
void add_notes(const SlopeRun<System>& end, double unit, const Names& ending, Sensitivity& result) {
  for (const bool is_end : {false, true}) add_slowest(end, is_end, unit, ending, result);
  for (const auto& one : end.coincident)
    result.notes.push_back(
        coincidence_note(one, unit, one.time == end.run.time ? ending : Names{},
                         names_of(result.parameter, [&](std::size_t c) { return one.apart[c]; })));
  const auto shared = names_of(result.parameter, [&](std::size_t c) { return end.time_is_shared[c]; });
  if (!shared.empty()) result.notes.push_back(shared_ending_note(ending, shared));
  if (end.unresolved > 0) add_doubt(unresolved_note(end.unresolved), result);
  if (end.time_is_noise) result.notes.push_back(noise_ending_note(ending));
}

}  // namespace mariotte::impact
