#include "mariotte/impact/bodies/bodies_impact.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/another_flow.hpp"
#include "mariotte/impact/bodies/bodies_balance.hpp"
#include "mariotte/impact/bodies/bodies_frame.hpp"
#include "mariotte/impact/bodies/bodies_watch.hpp"
#include "mariotte/impact/flow_uses.hpp"
#include "mariotte/impact/sampled_promise.hpp"
#include "mariotte/impact/slowing.hpp"
#include "mariotte/model/fault.hpp"

namespace mariotte::impact {

using model::BodyEvent;
using Run = hybrid::Trajectory<model::BodiesChange>;

namespace {

/// One change, as the run tells it.
struct OneEvent {
  double time;
  Index contact;
  BodyEvent event;
  double approach;
};

/// What touches at rest since the start is pressed or parts from then on, though that is told from rounding
/// later.
std::vector<OneEvent> events(const Run& run) {
  std::vector<OneEvent> list;
  list.reserve(run.changes.size());
  Index rested = -1;
  double told = -1;
  for (const auto& [time, change] : run.changes) {
    if (change.event == BodyEvent::touch) rested = change.contact, told = time;
    const bool from_start = change.contact == rested && time == told;
    list.push_back({from_start ? 0 : time, change.contact, change.event, change.approach});
  }
  const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
  if (!std::is_sorted(list.begin(), list.end(), earlier)) std::stable_sort(list.begin(), list.end(), earlier);
  return list;
}

void add_periods(const std::vector<OneEvent>& events, std::vector<BodyContactHistory>& contacts) {
  for (const auto& [time, contact, event, approach] : events) {
    auto& periods = contacts[contact].periods;
    auto& meeting = contacts[contact].meeting;
    if (event == BodyEvent::close || event == BodyEvent::touch) {
      periods.push_back({time, std::nullopt});
      if (periods.size() == 1) meeting.approach = approach;
    }
    if (event == BodyEvent::open) {
      periods.back().end = time;
      if (periods.size() == 1) meeting.separation = -approach;
    }
    if (event == BodyEvent::part) {
      periods.pop_back();
      if (periods.empty()) meeting = {};
    }
  }
}

double slowing(const std::vector<OneEvent>& events, const model::Bodies& bodies) {
  Slowing slowing;
  for (const auto& [time, contact, event, approach] : events) {
    if (!contact::adheres(bodies.contact[contact].law)) continue;
    if (event == BodyEvent::close) slowing.meet(contact, approach);
    if (event == BodyEvent::open) slowing.part(contact, -approach);
  }
  return slowing.most();
}

/// Keeps the contacts that are always told and those that have closed, and numbers events by them.
void keep_used(Index at_least, const std::vector<OneEvent>& events, BodiesImpact& impact) {
  const auto is_unused = [&](const BodyContactHistory& one) {
    return one.contact >= at_least && one.periods.empty();
  };
  std::vector<Index> place(impact.contacts.size(), -1);
  Index kept = 0;
  for (const auto& one : impact.contacts)
    if (!is_unused(one)) place[one.contact] = kept++;
  std::erase_if(impact.contacts, is_unused);
  impact.events.reserve(events.size());
  for (const auto& [time, contact, event, approach] : events) {
    if (place[contact] < 0) continue;
    if (impact.events.empty() || impact.events.back().time != time) impact.events.push_back({.time = time});
    impact.events.back().all[static_cast<std::size_t>(event)].push_back(place[contact]);
  }
}

/// `attainable` grows to the share of indentations that is rounding, which is the most that can be asked for.
template <int D>
BodiesImpact simulate_once(const model::Bodies& bodies, const hybrid::Options& options,
                           const RunObserver& observers, double& attainable) {
  using System = model::BodiesSystem<D>;
  const auto over = options.flies_on ? model::Over::at_time_limit : model::Over::separated;
  System system(bodies, model::setting_of<D>(bodies, options.accuracy, options.max_time), over);
  const auto start = initial_state(bodies, system.setting());
  hybrid::Workspace<System> workspace;
  BodiesObserver<D> watch(bodies, system, workspace.mode, observers);
  const Run& run = hybrid::simulate(system, start, options, workspace, &watch);
  watch.finish(run.time, run.state);

  BodiesImpact impact;
  impact.ending = run.ending;
  impact.message = run.message;
  impact.dimension = D;
  impact.time = run.time;
  impact.body = bodies_at(bodies, system.setting(), run.state);
  const auto told = events(run);
  impact.contacts = exchanged(system, workspace.mode, run.state);
  add_periods(told, impact.contacts);
  impact.slowing = slowing(told, bodies);
  for (std::size_t c = 0; c < impact.contacts.size(); ++c) {
    const auto& peak = watch.peaks()[c];
    impact.contacts[c].peak_force = peak.force;
    impact.contacts[c].peak_friction = peak.friction;
    impact.contacts[c].peak_indentation = peak.indentation;
    impact.contacts[c].between = {name_of(bodies, bodies.contact[c].a), name_of(bodies, bodies.contact[c].b)};
  }
  balance(bodies, system, start, run.state, impact.contacts, impact);
  impact.flows = flow_uses(run.flows);
  impact.requested_accuracy = options.accuracy;
  impact.trace = watch.take_trace();
  const auto list =
      balances(system, workspace.mode, start, run.state, impact.contacts, impact, options.accuracy);
  pass_gate(list, impact.ending, impact.message);
  keep_used(always_told(bodies), told, impact);
  attainable = std::max(attainable, system.setting().rounding);
  return impact;
}

/// Which bodies have met another one or a plane.
std::vector<char> have_met(const model::Bodies& bodies, const BodiesImpact& impact) {
  std::vector<char> met(bodies.body.size(), 0);
  for (const auto& one : impact.contacts) {
    const auto& contact = bodies.contact[one.contact];
    if (one.periods.empty()) continue;
    met[contact.b.owner] = 1;
    if (!contact.a.is_plane()) met[contact.a.owner] = 1;
  }
  return met;
}

/// Largest difference of velocities and of spin × reach, relative to the largest speed of what meets at the
/// start, at the end or at which contacts close, or at least to `speed`.
double difference(const model::Bodies& bodies, double speed, const BodiesImpact& a, const BodiesImpact& b) {
  double most = 0;
  const auto met = have_met(bodies, a);
  for (std::size_t i = 0; i < bodies.body.size(); ++i) {
    const auto& body = bodies.body[i];
    double reach = 0;
    for (const auto& sphere : body.spheres) reach = std::max(reach, norm(sphere.centre) + sphere.radius);
    const double apart = std::max(norm(a.body[i].velocity - b.body[i].velocity),
                                  reach * norm(a.body[i].spin - b.body[i].spin));
    if (std::isnan(apart)) return infinity;
    most = std::max(most, apart);
    if (met[i])
      speed = std::max({speed, norm(body.velocity), reach * norm(body.spin), norm(a.body[i].velocity)});
  }
  for (const auto& contact : a.contacts) speed = std::max(speed, contact.meeting.approach.value_or(0));
  return speed > 0 ? most / speed : most;
}

/// A contact that is pressed again before it has opened counts as closed again.
Passage passage(const BodiesImpact& impact, double attainable) {
  const auto closed = std::count_if(impact.contacts.begin(), impact.contacts.end(),
                                    [](const auto& one) { return !one.periods.empty(); });
  Passage gone{.contacts = closed,
               .harmless = closed,
               .flight = longest_flight(impact.contacts),
               .slowing = impact.slowing,
               .attainable = std::max(attainable, 16 * epsilon)};
  for (const auto& contact : impact.contacts) gone.periods += std::ssize(contact.periods);
  for (const auto& event : impact.events) gone.periods += std::ssize(event.of(BodyEvent::load));
  count_flows(gone, impact.flows);
  return gone;
}

template <int D>
BodiesImpact simulate_in(const model::Bodies& bodies, const hybrid::Options& options,
                         const RunObserver& observers) {
  const auto setting = model::setting_of<D>(bodies, options.accuracy, options.max_time);
  model::expect_digits(setting);
  double attainable = setting.rounding;
  auto possible = options;
  const auto run = [&](const model::Bodies& same, const hybrid::Options& how, const RunObserver& watched) {
    return simulate_once<D>(same, how, watched, attainable);
  };
  const auto run_as_possible = [&] {
    possible.accuracy = std::max(options.accuracy, attainable);
    return run(bodies, possible, observers);
  };
  auto impact = run_as_possible();
  if (attainable > possible.accuracy) {
    restart(observers);
    impact = run_as_possible();
  }
  keep_promise(bodies, possible, passage(impact, attainable), observers, impact, run,
               [&](const auto& a, const auto& b) { return difference(bodies, setting.sag_speed, a, b); });
  impact.lost_digits = attainable;
  if (attainable > options.accuracy)
    impact.estimated_accuracy = std::max(attainable, impact.estimated_accuracy.value_or(0));
  impact.requested_accuracy = options.accuracy;
  return impact;
}

BodiesImpact simulate_seen(const model::Bodies& bodies, const hybrid::Options& options,
                           const RunObserver& observers) {
  return bodies.dimension == 2 ? simulate_in<2>(bodies, options, observers)
                               : simulate_in<3>(bodies, options, observers);
}

}  // namespace

BodiesImpact simulate(const model::Bodies& bodies, const hybrid::Options& options,
                      const RunObserver& observers) {
  model::validate(bodies);
  hybrid::validate(options);
  model::expect_end(bodies, options.max_time);
  return run_within(moving_frame(bodies), bodies, observers,
                    [&](const auto& same, const auto& told) { return simulate_seen(same, options, told); });
}

double estimate_accuracy(const model::Bodies& bodies, const hybrid::Options& options,
                         const BodiesImpact& result) {
  auto tighter = options;
  tighter.accuracy = std::max(options.accuracy / 32, 16 * epsilon);
  const auto own = simulate(bodies, tighter);
  const double least = bodies.dimension == 2
                           ? model::setting_of<2>(bodies, options.accuracy, options.max_time).sag_speed
                           : model::setting_of<3>(bodies, options.accuracy, options.max_time).sag_speed;
  const auto apart = [&](const BodiesImpact& other) { return difference(bodies, least, result, other); };
  const double from_tighter = error_bound(apart(own), own.estimated_accuracy);
  constexpr Index most_bodies = 50;  // of more CVODE takes minutes
  if (std::ssize(bodies.body) > most_bodies || has_no_other(result, options)) return from_tighter;
  return beside_another_flow(
      from_tighter, tighter, another_flow(options), 10 * cvode_floor,
      [&](const auto& how) { return simulate(bodies, how); }, apart);
}

}  // namespace mariotte::impact
