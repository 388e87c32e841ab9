#include "mariotte/impact/microbody/microbody_impact.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/another_flow.hpp"
#include "mariotte/impact/flow_uses.hpp"
#include "mariotte/impact/microbody/microbody_difference.hpp"
#include "mariotte/impact/microbody/microbody_gate.hpp"
#include "mariotte/impact/microbody/microbody_slowing.hpp"
#include "mariotte/impact/microbody/microbody_watch.hpp"
#include "mariotte/impact/sampled_promise.hpp"

namespace mariotte::impact {

using model::MicrobodySystem;
using model::TipEvent;
using Run = hybrid::Trajectory<MicrobodySystem::Change>;

namespace {

std::vector<Index>& list_of(TipEvents& events, TipEvent event) {
  switch (event) {
    case TipEvent::open:
      return events.open;
    case TipEvent::close:
      return events.close;
    case TipEvent::stick:
      return events.stick;
    case TipEvent::slip:
      return events.slip;
    case TipEvent::force_positive:
      return events.push;
    case TipEvent::force_negative:
      return events.pull;
    case TipEvent::capture:
      break;
  }
  return events.capture;
}

std::vector<TipEvents> events(const Run& run, double unit) {
  std::vector<TipEvents> list;
  for (const auto& [time, change] : run.changes) {
    if (list.empty() || list.back().time != time * unit) list.push_back({.time = time * unit});
    list_of(list.back(), change.event).push_back(change.tip);
  }
  return list;
}

/// The state at an event: the beginning of the phase after it, or the end of the run.
ConstState state_at(const Run& run, const MicrobodyObserver& watch, double time) {
  for (const auto& one : watch.milestones())
    if (one.time == time) return one.state;
  return run.state;
}

void start_impact(TipImpact& impact, const MicrobodySystem& system, ConstState x) {
  const double unit = system.body().scale.velocity;
  impact.normal_velocity_in = unit * system.mechanics().tip(x, impact.tip).velocity;
  impact.centre_velocity_in = unit * x[system.layout().place.velocity];
}

void end_impact(TipImpact& impact, const MicrobodySystem& system, double time, ConstState x) {
  const auto& scale = system.body().scale;
  const auto tip = system.mechanics().tip(x, impact.tip);
  impact.end = time * scale.time;
  impact.normal_velocity_out = scale.velocity * tip.velocity;
  impact.centre_velocity_out = scale.velocity * x[system.layout().place.velocity];
  impact.slip_out = scale.velocity * tip.slip;
}

void add_peaks(TipImpact& impact, const MicrobodySystem& system, const MicrobodyObserver& watch) {
  const auto& scale = system.body().scale;
  TipPeaks peaks;
  for (std::size_t k = 0; k < watch.milestones().size(); ++k) {
    const double time = watch.milestones()[k].time * scale.time;
    if (time < impact.start || (impact.end && time >= *impact.end)) continue;
    raise(peaks, watch.peaks()[k][impact.tip], all_tip_peaks);
  }
  impact.peak_force = peaks.push * scale.force();
  impact.peak_pull = peaks.pull * scale.force();
  impact.peak_indentation = peaks.depth * scale.length;
}

std::vector<TipImpact> impacts(const MicrobodySystem& system, const Run& run,
                               const MicrobodyObserver& watch) {
  std::vector<TipImpact> list;
  for (const auto& [time, change] : run.changes) {
    const auto x = state_at(run, watch, time);
    if (change.event == TipEvent::close) {
      list.push_back({.tip = change.tip, .start = time * system.body().scale.time});
      start_impact(list.back(), system, x);
    }
    if (change.event != TipEvent::open) continue;
    const auto open = std::find_if(list.rbegin(), list.rend(), [tip = change.tip](const TipImpact& impact) {
      return impact.tip == tip && !impact.end;
    });
    end_impact(*open, system, time, x);
  }
  for (auto& impact : list) add_peaks(impact, system, watch);
  return list;
}

/// Height of the mass centre, dimensionless.
double centre_height(const MicrobodySystem& system, ConstState x) {
  return body_state(system, 0, x).position.e1 / system.body().scale.length;
}

MicrobodyBalance balance(const MicrobodySystem& system, ConstState before, ConstState after) {
  const auto& body = system.body();
  const Index work = system.layout().place.work;
  MicrobodyBalance energy{.initial = system.mechanics().kinetic(before),
                          .final = system.mechanics().kinetic(after),
                          .stored = system.mechanics().stored(after),
                          .hertz_damping = after[work],
                          .adhesion_damping = after[work + 1],
                          .friction = after[work + 2]};
  if (body.gravity != 0)
    energy.work =
        body.body.mass * body.gravity * (centre_height(system, before) - centre_height(system, after));
  energy.residual = energy.final + energy.stored + energy.dissipated() - energy.initial - energy.work;
  for (double* entry : {&energy.initial, &energy.final, &energy.stored, &energy.hertz_damping,
                        &energy.adhesion_damping, &energy.friction, &energy.work, &energy.residual})
    *entry *= body.scale.energy();
  return energy;
}

std::vector<Skipped> skipped(const MicrobodySystem& system, const model::Microbody& body, const Run& run,
                             bool trace) {
  using Motion = flow::TipPhase::Motion;
  const auto& d = system.body();
  const auto used = [&](flow::Kind kind) { return run.flows[static_cast<std::size_t>(kind)].phases; };
  std::vector<Skipped> list;
  if (d.motion == Motion::normal)
    list.push_back(
        {"tangential motion and rotation", "the impact is central: two states, indentation and speed"});
  if (d.motion == Motion::planar)
    list.push_back({"motion out of the plane", "none at the start, and no force leads there: six states"});
  if (body.friction.coefficient == 0) list.push_back({"friction guards", "no friction"});
  if (d.motion == Motion::normal && body.friction.coefficient > 0)
    list.push_back({"friction guards", "nothing slips and sticking needs no force"});
  if (d.law[0].adhesion == 0) list.push_back({"adhesion", "no work of adhesion"});
  if (d.law[0].damping_hertz == 0 && d.law[0].damping_adhesion == 0)
    list.push_back({"dissipation of the contact", "no damping"});
  if (const Index flights = used(flow::Kind::ballistic))
    list.push_back({"integration of free flight", phases(flights) + " in closed form"});
  if (d.tips() < body.body.tips.size())
    list.push_back({"the other tip", "only the first impact was asked for"});
  if (!trace) list.push_back({"trace", "not asked for"});
  return list;
}

MicrobodyImpact simulate_once(const model::Microbody& body, const hybrid::Options& options,
                              const RunObserver& observers) {
  MicrobodySystem system(body, options.accuracy, /*balance=*/true);
  const auto start = initial_state(system.body(), system.layout());
  MicrobodyObserver watch(system, observers);
  hybrid::Workspace<MicrobodySystem> workspace;
  const auto& scale = system.body().scale;
  auto run_options = hybrid::scaled(options, scale);
  run_options.accuracy = system.accuracy();
  const Run& run = hybrid::simulate(system, start, run_options, workspace, &watch);
  watch.finish(run.time, run.state);

  MicrobodyImpact impact;
  impact.ending = run.ending;
  impact.message = run.message;
  impact.final = body_state(system, run.time, run.state);
  impact.impacts = impacts(system, run, watch);
  if (!impact.impacts.empty() && impact.impacts[0].end) {
    const auto& first = impact.impacts[0];
    impact.restitution = restitution(first.normal_velocity_in, first.normal_velocity_out,
                                     first.centre_velocity_in, first.centre_velocity_out);
  }
  impact.events = events(run, scale.time);
  if (run.ending == hybrid::Ending::captured) {
    const Index tip = run.changes.back().change.tip;
    impact.rest = RestState{tip, contact::rest_indentation(body.law[tip])};
  }
  impact.shared_friction = watch.shared_friction();
  impact.energy = balance(system, start, run.state);
  impact.impulse = body.body.mass *
                   (impact.final.velocity - body.velocity + body.gravity * impact.final.time * normal_axis);
  impact.flows = flow_uses(run.flows);
  impact.slowing = slowing(system, start, run);
  impact.skipped = skipped(system, body, run, observers.trace);
  impact.requested_accuracy = options.accuracy;
  impact.trace = watch.take_trace();
  pass_gate(balances(system, start, run.state, workspace.mode), impact.ending, impact.message);
  return impact;
}

}  // namespace

bool has_restitution(const MicrobodyImpact& impact) {
  return impact.rest || (!impact.impacts.empty() && impact.impacts[0].end);
}

MicrobodyImpact simulate(const model::Microbody& body, const hybrid::Options& options,
                         const RunObserver& observers) {
  model::validate(body);
  hybrid::validate(options);
  auto impact = simulate_once(body, options, observers);
  Passage gone{.contacts = std::ssize(body.body.tips),
               .harmless = single_impact,
               .periods = std::ssize(impact.impacts),
               .slowing = impact.slowing};
  count_flows(gone, impact.flows);
  keep_promise(body, options, gone, observers, impact, simulate_once, [&](const auto& a, const auto& b) {
    return difference(body, a.final.velocity - b.final.velocity, a.final.spin - b.final.spin);
  });
  impact.requested_accuracy = options.accuracy;
  return impact;
}

double estimate_accuracy(const model::Microbody& body, const hybrid::Options& options,
                         const MicrobodyImpact& result) {
  auto tighter = options;
  tighter.accuracy = std::max(1e-2 * options.accuracy, 16 * epsilon);
  const auto apart = [&](const MicrobodyImpact& other) {
    return difference(body, result.final.velocity - other.final.velocity,
                      result.final.spin - other.final.spin);
  };
  const auto own = simulate(body, tighter);
  const double from_tighter = error_bound(apart(own), own.estimated_accuracy);
  if (has_no_other(result, options)) return from_tighter;
  return beside_another_flow(
      from_tighter, tighter, another_flow(options), cvode_floor,
      [&](const auto& how) { return simulate(body, how); }, apart);
}

}  // namespace mariotte::impact
