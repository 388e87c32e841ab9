#include "mariotte/impact/network/network_impact.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/another_flow.hpp"
#include "mariotte/impact/energy.hpp"
#include "mariotte/impact/flow_uses.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/network/network_balance.hpp"
#include "mariotte/impact/network/network_frame.hpp"
#include "mariotte/impact/network/network_gate.hpp"
#include "mariotte/impact/network/network_run.hpp"
#include "mariotte/impact/network/network_solver.hpp"
#include "mariotte/impact/reached_speed.hpp"
#include "mariotte/impact/sampled_promise.hpp"
#include "mariotte/impact/slowing.hpp"
#include "mariotte/impact/watch/contact_watch.hpp"
#include "mariotte/model/network/network_system.hpp"

namespace mariotte::impact {

using model::NetworkSystem;

namespace {

/// Impulse and energies of contact j.
ContactHistory history(const NetworkSystem& system, const contact::ContactSet& mode, Index j,
                       const Interval& interval, double accuracy) {
  const auto& d = system.network();
  const auto& at = system.layout();
  ContactHistory contact;
  const double impulse = interval.after[at.impulse[j]];
  contact.impulse = is_faint(d, j, impulse) ? 0 : impulse * d.scale.momentum();
  const auto energy = contact_energy(d, at, mode, interval, j);
  const double noise = accuracy * d.reduced_mass[j] * d.speed * d.speed;
  contact.stored = energy.stored * d.scale.energy();
  contact.dissipated = loss_above(noise, energy.dissipated) * d.scale.energy();
  contact.plastic = energy.plastic * d.scale.energy();
  contact.adhesion = energy.adhesion * d.scale.energy();
  contact.permanent_indentation = energy.dent * d.scale.length;
  return contact;
}

/// By contact: its impulse is more than the accuracy leaves open.
std::vector<bool> felt(const NetworkSystem& system, const ContactRun& run, double accuracy) {
  std::vector<bool> list;
  for (Index j = 0; j < system.network().contacts(); ++j)
    list.push_back(is_felt(system.network(), j, run.state[system.layout().impulse[j]], accuracy));
  return list;
}

std::vector<ContactHistory> histories(const NetworkSystem& system, const contact::ContactSet& mode,
                                      const Interval& interval, const ContactChanges& changes,
                                      const std::vector<Peak>& peaks, double accuracy) {
  const auto& scale = system.network().scale;
  std::vector<ContactHistory> contacts;
  for (Index j = 0; j < std::ssize(mode); ++j) {
    contacts.push_back(history(system, mode, j, interval, accuracy));
    contacts[j].peak_force = peaks[j].force * scale.force();
    const double at_start = -system.network().gap[j];  // a slack contact is never deeper
    contacts[j].peak_indentation = std::max(peaks[j].indentation, at_start) * scale.length;
  }
  add_periods(contacts, changes, scale);
  for (auto& contact : contacts)
    if (contact.periods.empty()) contact.impulse = 0;
  return contacts;
}

std::vector<Skipped> skipped(const NetworkSystem& system, const ContactRun& run, bool trace) {
  auto list = skipped_by_flows(run);
  const auto& work = system.layout().work;
  if (std::all_of(work.begin(), work.end(), [](Index p) { return p == model::ContactLayout::absent; }))
    list.push_back({"dissipation", "no contact is damped"});
  if (!trace) list.push_back({"trace", "not asked for"});
  return list;
}

Trace named(Trace trace, const model::Network& network) {
  trace.moving = moving(network);
  trace.velocity_unit = velocity_unit(network);
  trace.dimension = std::max<Index>(1, network.dimension);
  return trace;
}

NetworkImpact simulate_once(const model::Network& network, const hybrid::Options& options,
                            const RunObserver& observers) {
  NetworkSystem system(network, options.accuracy, /*stay=*/std::isfinite(options.max_time));
  const auto& scale = system.network().scale;
  const auto& at = system.layout();
  std::vector<double> start;
  initial_state(system.network(), at, start);
  ContactWatch watch(system.phase(), scale, system.network().time, observers);
  if (!network.distance.empty()) watch.turning.emplace(network, system.phase(), scale);
  hybrid::Workspace<NetworkSystem> workspace;
  const ContactRun& run = hybrid::simulate(system, start, hybrid::scaled(options, scale), workspace, &watch);
  system.problem(workspace.mode);  // forces at the ending are those of the last mode
  watch.finish(run.time, run.state);

  NetworkImpact impact;
  impact.ending = run.ending;
  impact.message = run.message;
  impact.time = run.time * scale.time;
  for (Index i = 0; i < at.velocities(); ++i) impact.velocity.push_back(run.state[i] * scale.velocity);
  for (Index j = 0; j < at.contacts(); ++j) impact.gap.push_back(run.state[at.gap[j]] * scale.length);
  const auto changes = beyond_noise(run.changes, felt(system, run, options.accuracy));
  impact.contacts = histories(system, workspace.mode, {start, run.state, run.time}, changes,
                              watch.peaks.peaks(), options.accuracy);
  const auto p = impulses_of(impact);
  impact.icr = correlation_ratios(p);
  impact.impulse_direction = direction(p);
  impact.events = event_list(changes, scale.time);
  const auto before = configuration_of(network);
  double work = 0;
  for (const Index place : at.drive_work) work += run.state[place] * scale.energy();
  impact.energy = energy_balance(network, before, impact, work);
  impact.momentum_residual = momentum_residual(network, before, impact);
  impact.bound_frequency = bound_frequencies(system, workspace.mode, run, scale);
  impact.flows = flow_uses(run.flows);
  impact.slowing = slowing(system, workspace.mode, run, system.network().law);
  impact.faded = faded_contacts(changes, system.network().law);
  if (watch.turning) impact.turning = watch.turning->largest();
  impact.skipped = skipped(system, run, observers.trace);
  impact.requested_accuracy = options.accuracy;
  if (observers.trace) impact.trace = named(watch.trace.take(run.time, run.state), network);
  NetworkGate().pass({system.network(), at, workspace.mode, {start, run.state, run.time}}, options.accuracy,
                     impact.ending, impact.message);
  return impact;
}

NetworkImpact simulate_known(const model::Network& network, const hybrid::Options& options,
                             const RunObserver& observers) {
  auto impact = simulate_once(network, options, observers);
  keep_promise(network, options, passage(impact), observers, impact, simulate_once,
               [&](const auto& a, const auto& b) {
                 return rate_difference(network, reference_speed(network), a.velocity, b.velocity);
               });
  add_rounding(passage(impact), network, options.accuracy, impact.estimated_accuracy);
  impact.requested_accuracy = options.accuracy;
  return impact;
}

NetworkImpact simulate_seen(const model::Network& network, const hybrid::Options& options,
                            const RunObserver& observers) {
  if (network.drive.empty()) return simulate_known(network, options, observers);
  return simulate_known(with_reached_speeds(network, options, observers, simulate_once), options, observers);
}

}  // namespace

Configuration configuration_of(const model::Network& network) {
  return {.mass = network.mass, .contact = network.direction, .velocity = network.velocity};
}

NetworkImpact simulate(const model::Network& network, const hybrid::Options& options,
                       const RunObserver& observers) {
  model::validate(network);
  hybrid::validate(options);
  model::expect_end(network, options.max_time);
  return run_within(moving_frame(network), network, observers,
                    [&](const auto& same, const auto& told) { return simulate_seen(same, options, told); });
}

model::Network with_reached_speeds(const model::Network& network, const hybrid::Options& options) {
  return with_reached_speeds(network, options, {}, simulate_once);
}

double estimate_accuracy(const model::Network& network, const hybrid::Options& options,
                         const NetworkImpact& result) {
  auto tighter = options;
  tighter.accuracy = std::max(1e-2 * options.accuracy, 16 * epsilon);
  NetworkSolver solver;
  const auto& own = solver.solve(network, tighter);
  const double speed =
      reference_speed(network.drive.empty() ? network : with_reached_speeds(network, options));
  const auto apart = [&](const auto& other) {
    return rate_difference(network, speed, result.velocity, other.velocity);
  };
  const double from_tighter = error_bound(apart(own), own.estimated_accuracy);
  constexpr Index most_contacts = 200;  // of more CVODE takes minutes
  if (std::ssize(network.direction) > most_contacts || has_no_other(result, options)) return from_tighter;
  return beside_another_flow(
      from_tighter, tighter, another_flow(options),
      cvode_floor, [&](const auto& how) -> const auto& { return solver.solve(network, how); }, apart);
}

}  // namespace mariotte::impact
