// From the run of a chain or network to its brief impact, the same for both.
#pragma once
#include <algorithm>
#include <numeric>
#include <utility>

#include "mariotte/core/scale.hpp"
#include "mariotte/hybrid/trajectory.hpp"
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/promise.hpp"
#include "mariotte/impact/slowing.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"

namespace mariotte::impact {

/// Fills in all but impulses, periods and estimate, in units. `Run` is a trajectory over contacts.
template <class Run>
void describe(const Run& run, const model::ContactLayout& layout, const Scale& scale, BriefImpact& impact) {
  impact.ending = run.ending;
  impact.message = run.message;
  impact.time = run.time * scale.time;
  impact.velocity.clear();
  for (const Index at : layout.velocity) impact.velocity.push_back(run.state[at] * scale.velocity);
  impact.events = run.events;
  impact.steps = impact.rhs = 0;
  for (const auto& flow : run.flows) {
    impact.steps += flow.steps;
    impact.rhs += flow.rhs;
  }
}

/// What a run has gone through whose contacts had these periods and laws.
template <class Run>
Passage passage(const Run& run, const std::vector<Index>& periods, const std::vector<contact::Law>& laws) {
  Passage gone{.contacts = std::ssize(periods),
               .harmless = single_wave(std::ssize(periods)),
               .periods = std::accumulate(periods.begin(), periods.end(), Index{0}),
               .most = periods.empty() ? 0 : *std::max_element(periods.begin(), periods.end())};
  for (const auto kind : flow::kinds) {
    const auto& flow = run.flows[static_cast<std::size_t>(kind)];
    count_flow(gone, kind, flow.phases, flow.steps);
  }
  gone.floor = floor_of_cvode(gone);
  Flights flights;
  for (const auto& [time, change] : run.changes) {
    if (starts_force(change)) flights.begin(time);
    if (ends_force(change)) flights.end(time);
  }
  gone.flight = flights.longest();
  gone.slowing = slowing(run.changes, laws);
  return gone;
}

}  // namespace mariotte::impact
