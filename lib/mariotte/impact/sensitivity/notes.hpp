// What is to be said of slopes that are large, one-sided or missing.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/slope_run.hpp"

namespace mariotte::impact {

/// "contact 2 crosses at 1.2e-05 of the natural speed at 3.5 s: …".
std::string grazing_note(const std::string& what, double speed, double time);
std::string coincidence_note(const std::string& first, const std::string& second, double time);
std::string near_closing_note(const std::string& what, double speed);
std::string hardly_touching_note(const std::string& what, double speed);
std::string slip_from_rest_note();
std::string shared_ending_note();
std::string noise_ending_note();
std::string slow_ending_note(double error);
std::string waiting_note();
std::string unresolved_note(double error);
/// Slopes that are no numbers are left out; a note says so.
void leave_out_unbounded(Sensitivity& slopes);
/// Throws InvalidParameter for more slopes than memory and patience allow.
void expect_few(Index components, Index parameters);

/// Notes of a run; `unit` is that of time [s].
template <class System>
void add_notes(const SlopeRun<System>& end, double unit, std::vector<std::string>& notes) {
  if (const auto& one = end.delicate) notes.push_back(grazing_note(one->what, one->speed, one->time * unit));
  for (const auto& one : end.coincident)
    notes.push_back(coincidence_note(one.first, one.second, one.time * unit));
  if (std::find(end.time_is_shared.begin(), end.time_is_shared.end(), true) != end.time_is_shared.end())
    notes.push_back(shared_ending_note());
  if (end.unresolved > 0) notes.push_back(unresolved_note(end.unresolved));
  if (end.time_is_noise) notes.push_back(noise_ending_note());
}

}  // namespace mariotte::impact
