#include "mariotte/impact/chain/chain_impact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mariotte/core/counted.hpp"
#include "mariotte/impact/another_flow.hpp"
#include "mariotte/impact/chain/chain_frame.hpp"
#include "mariotte/impact/chain/chain_gate.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/flow_uses.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/reached_speed.hpp"
#include "mariotte/impact/sampled_promise.hpp"
#include "mariotte/impact/slowing.hpp"
#include "mariotte/impact/watch/chain_run.hpp"
#include "mariotte/impact/watch/event_list.hpp"
#include "mariotte/impact/watch/sampler.hpp"
#include "mariotte/impact/watch/trace.hpp"
#include "mariotte/model/contacts/scaled_contacts.hpp"

namespace mariotte::impact {

using model::ChainLayout;
using model::DimensionlessChain;
using Run = model::Islands::Run;

namespace {

/// A wave that repeats itself was moved on.
void skip_steady(Index moved_on, std::vector<Skipped>& list) {
  if (moved_on > 0)
    list.push_back({"steady waves", "the passage of " + counted(moved_on, "ball") +
                                        " was not followed: the wave did to them what it had done before"});
}

/// What islands did not have to do.
void skip_at_rest(const model::IslandCount& islands, Index contacts, std::vector<Skipped>& list) {
  list.push_back({"balls at rest or in free flight",
                  "at most " + std::to_string(islands.widest) + " of " + std::to_string(contacts) +
                      " contacts were integrated together, in " + std::to_string(islands.formed) +
                      " islands, up to " + std::to_string(islands.at_once) + " at one time"});
}

std::vector<Skipped> skipped(const ChainLayout& layout, const ChainRun& chain_run, bool trace) {
  const auto none = [](const std::vector<Index>& places) {
    return std::all_of(places.begin(), places.end(), [](Index p) { return p == ChainLayout::absent; });
  };
  std::vector<Skipped> list;
  if (chain_run.islands) skip_at_rest(*chain_run.islands, layout.contacts(), list);
  if (chain_run.islands) skip_steady(chain_run.islands->moved_on, list);
  const auto by_flows = skipped_by_flows(chain_run.run);
  list.insert(list.end(), by_flows.begin(), by_flows.end());
  if (none(layout.work)) list.push_back({"dissipation", "no contact is damped"});
  if (none(layout.impulse))
    list.push_back({"impulse integrals", "momentum gives every impulse of a chain without walls"});
  if (!trace) list.push_back({"trace", "not asked for"});
  return list;
}

std::vector<ContactHistory> histories(const DimensionlessChain& chain, const ChainRun& chain_run,
                                      const std::vector<double>& p,
                                      const std::vector<ContactEnergy>& energies, double accuracy) {
  const auto& scale = chain.scale;
  const double speed = chain.speed;
  const auto& peaks = chain_run.peaks;
  std::vector<ContactHistory> contacts(p.size());
  for (std::size_t j = 0; j < contacts.size(); ++j)
    contacts[j] = {
        .impulse = p[j] * scale.momentum(),
        .peak_force = peaks[j].force * scale.force(),
        // A contact that is slack from the start is never deeper.
        .peak_indentation = std::max(peaks[j].indentation, -chain.gap[j]) * scale.length,
        .stored = energies[j].stored * scale.energy(),
        .dissipated = loss_above(accuracy * chain.reduced_mass[j] * speed * speed, energies[j].dissipated) *
                      scale.energy(),
        .plastic = energies[j].plastic * scale.energy(),
        .adhesion = energies[j].adhesion * scale.energy(),
        .permanent_indentation = energies[j].dent * scale.length,
        .periods = {},
        .meeting = {}};
  add_periods(contacts, chain_run.run.changes, scale);
  return contacts;
}

/// Everything asked for, in the chain's units.
ChainImpact describe(const DimensionlessChain& chain, const ChainLayout& layout, ConstState start,
                     const ChainRun& chain_run, double accuracy) {
  const Run& run = chain_run.run;
  const auto& scale = chain.scale;
  const Interval interval{.before = start, .after = run.state, .time = run.time};
  std::vector<double> p;
  std::vector<Index> periods;
  impulses(chain, layout, interval, p);
  count_periods(run.changes, layout.contacts(), periods);
  std::vector<ContactEnergy> energies;
  contact_energies(chain, layout, chain_run.mode, interval, energies);

  ChainImpact impact;
  impact.ending = run.ending;
  impact.message = run.message;
  pass_gate({chain, layout, chain_run.mode, interval, p, periods, energies}, accuracy, impact.ending,
            impact.message);
  clear_faint(chain, periods, p);
  impact.time = run.time * scale.time;
  for (const Index at : layout.velocity) impact.velocity.push_back(run.state[at] * scale.velocity);
  for (const Index at : layout.gap) impact.gap.push_back(run.state[at] * scale.length);
  impact.contacts = histories(chain, chain_run, p, energies, accuracy);
  impact.icr = correlation_ratios(p);
  impact.impulse_direction = direction(p);
  impact.events = event_list(run.changes, scale.time);
  impact.energy = in_units(energy_balance(chain, layout, energies, p, interval), scale);
  impact.momentum = in_units(momentum_balance(chain, layout, interval), scale);
  impact.flows = flow_uses(run.flows);
  impact.slowing = slowing(run.changes, chain.law);
  impact.faded = faded_contacts(run.changes, chain.law);
  return impact;
}

ChainImpact simulate_whole(const model::Chain& chain, const hybrid::Options& options,
                           const RunObserver& observers) {
  model::ChainSystem system;
  system.reset(chain, options.accuracy, /*stay=*/std::isfinite(options.max_time));
  std::vector<double> start;
  initial_state(system.chain(), system.layout(), start);
  auto chain_run = follow_whole(system, start, hybrid::scaled(options, system.chain().scale), observers);
  auto impact = describe(system.chain(), system.layout(), start, chain_run, options.accuracy);
  impact.bound_frequency = bound_frequencies(system, chain_run.mode, chain_run.run, system.chain().scale);
  impact.slowing = slowing(system, chain_run.mode, chain_run.run, chain.law);
  impact.skipped = skipped(system.layout(), chain_run, observers.trace);
  impact.trace = std::move(chain_run.trace);
  return impact;
}

/// All balls and contacts of a chain, kept by `trace`.
Sampling whole_trace(SampledTrace& trace, std::size_t balls) {
  Sampling sampling{.velocities = std::vector<Index>(balls),
                    .contacts = std::vector<Index>(balls - 1),
                    .take = [&trace](const Sample& sample) { return trace.take(sample); }};
  std::iota(sampling.velocities.begin(), sampling.velocities.end(), 0);
  std::iota(sampling.contacts.begin(), sampling.contacts.end(), 0);
  return sampling;
}

ChainImpact simulate_islands(const model::Chain& chain, const hybrid::Options& options,
                             RunObserver observers) {
  DimensionlessChain scaled;
  ChainLayout layout;
  std::vector<double> start;
  make_dimensionless(chain, options.accuracy, scaled);
  const auto inner = tightened(options, chain.mass.size());
  fade_later(scaled, inner.accuracy);
  make_layout(scaled, layout);
  initial_state(scaled, layout, start);
  SampledTrace trace;
  if (observers.trace) observers.samplings.push_back(whole_trace(trace, chain.mass.size()));
  SamplingObserver sampler(scaled, observers);
  const bool looks_on = !observers.samplings.empty() || observers.progress || observers.gives_up;
  const auto chain_run =
      follow_islands(scaled, layout, start, hybrid::scaled(inner, scaled.scale),
                     /*stay=*/std::isfinite(options.max_time), looks_on ? &sampler : nullptr);
  auto impact = describe(scaled, layout, start, chain_run, options.accuracy);
  impact.skipped = skipped(layout, chain_run, observers.trace);
  impact.trace = trace.take();
  return impact;
}

ChainImpact simulate_once(const model::Chain& chain, const hybrid::Options& options,
                          const RunObserver& observers) {
  const auto balls = chain.mass.size();
  auto impact = divides(options, chain) ? simulate_islands(chain, options, observers)
                                        : simulate_whole(chain, tightened(options, balls), observers);
  impact.requested_accuracy = options.accuracy;
  return impact;
}

/// BDF where contacts are damped so strongly that it would take over from Adams' method.
std::optional<flow::Kind> another_flow(const model::Chain& chain, const hybrid::Options& options) {
  const auto kind = impact::another_flow(options);
  if (!kind) return kind;
  constexpr double stiff = 5;  // as flow::choose has it
  DimensionlessChain scaled;
  make_dimensionless(chain, options.accuracy, scaled);
  for (std::size_t j = 0; j < scaled.law.size(); ++j)
    if (damping_group(scaled, j) > stiff) return flow::Kind::cvode_bdf_klu;
  return kind;
}

/// Waves may be moved on; where a flow is asked for by name they are followed.
bool may_have_steady_waves(const model::Chain& chain) {
  return std::any_of(chain.law.begin(), chain.law.end(), model::lets_waves_be_steady);
}

ChainImpact simulate_known(const model::Chain& chain, const hybrid::Options& options,
                           const RunObserver& observers) {
  auto impact = simulate_once(chain, options, observers);
  keep_promise(chain, options, passage(impact), observers, impact, simulate_once,
               [&](const auto& a, const auto& b) {
                 return difference(a.velocity, b.velocity, reference_speed(chain), chain.drive);
               });
  add_rounding(passage(impact), chain, options.accuracy, impact.estimated_accuracy);
  impact.requested_accuracy = options.accuracy;
  if (impact.ending == hybrid::Ending::failed && falls_back(chain) && std::isinf(options.max_time))
    impact.message += "; balls that come to rest under gravity need a time limit";
  return impact;
}

ChainImpact simulate_seen(const model::Chain& chain, const hybrid::Options& options,
                          const RunObserver& observers) {
  if (chain.drive.empty()) return simulate_known(chain, options, observers);
  return simulate_known(with_reached_speeds(chain, options, observers, simulate_once), options, observers);
}

}  // namespace

ChainImpact simulate(const model::Chain& chain, const hybrid::Options& options,
                     const RunObserver& observers) {
  model::validate(chain);
  hybrid::validate(options);
  model::expect_end(chain, options.max_time);
  return run_within(moving_frame(chain), chain, observers,
                    [&](const auto& same, const auto& told) { return simulate_seen(same, options, told); });
}

model::Chain with_reached_speeds(const model::Chain& chain, const hybrid::Options& options) {
  return with_reached_speeds(chain, options, {}, simulate_once);
}

double estimate_accuracy(const model::Chain& chain, const hybrid::Options& options,
                         const ChainImpact& result) {
  const double speed = reference_speed(chain.drive.empty() ? chain : with_reached_speeds(chain, options));
  ChainSolver solver;
  auto tighter = options;
  tighter.accuracy = std::max(1e-2 * options.accuracy, 16 * epsilon);
  if (divides(options, chain) && !options.flow && may_have_steady_waves(chain))
    tighter.flow = flow::Kind::taylor;
  const auto& own = solver.solve(chain, tighter);
  const double from_tighter =
      error_bound(difference(result.velocity, own.velocity, speed, chain.drive), own.estimated_accuracy);
  if (divides(options, chain)) return from_tighter;
  return beside_another_flow(
      from_tighter, tighter, another_flow(chain, options),
      cvode_floor, [&](const auto& how) -> const auto& { return solver.solve(chain, how); },
      [&](const auto& other) { return difference(result.velocity, other.velocity, speed, chain.drive); });
}

}  // namespace mariotte::impact
