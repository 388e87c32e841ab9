// What is to be said of slopes that are large, one-sided or missing.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/slope_run.hpp"

namespace mariotte::impact {

/// "contact 2 crosses at 1.2e-05 of the natural speed at 3.5 s: …".
std::string grazing_note(const std::string& what, double speed, double time);
std::string shared_ending_note();
std::string noise_ending_note();

/// Notes of a run; `name(guard)` says whose guard it is, `unit` is that of time [s].
template <class System, class Name>
void add_notes(const SlopeRun<System>& end, double unit, Name&& name, std::vector<std::string>& notes) {
  for (const auto& one : end.delicate)
    notes.push_back(grazing_note(name(one.guard), one.speed, one.time * unit));
  if (end.time_is_shared) notes.push_back(shared_ending_note());
  if (end.time_is_noise) notes.push_back(noise_ending_note());
}

}  // namespace mariotte::impact
