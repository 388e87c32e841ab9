#include "measure.hpp"

#include <algorithm>
#include <exception>
#include <functional>

#include "mariotte/flow/choose.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "measuring/timing.hpp"

namespace mariotte::stiffness_study {
namespace {

constexpr Index most_events = 20000;  // a chain of 21 balls has some dozens; more is chatter
constexpr int batches = 5;

hybrid::Options options(const ImpactCase& one, const Request& request) {
  return {.accuracy = request.accuracy,
          .max_time = request.longest * natural_time(one),
          .max_events = most_events,
          .flow = flow::parse_kind(request.flow)};
}

std::vector<std::string> contact_flows(const impact::ContactImpact& impact) {
  std::vector<std::string> names;
  for (const auto& use : impact.flows)
    if (use.name != "ballistic") names.push_back(use.name);
  return names;
}

// Touching contacts close at 0+; when a resting one is first pressed is a matter of tolerance.
std::vector<double> instants_after_onset(const impact::ContactImpact& impact, double unit) {
  std::vector<double> instants;
  for (const auto& event : impact.events)
    if (event.time > 0) instants.push_back(event.time / unit);
  return instants;
}

// A single contact is what is left of any impact when the others have opened; a flow that can follow nothing
// else has not followed the impact.
bool admits(const std::vector<std::string>& used, const std::string& flow) {
  const bool some = std::find(used.begin(), used.end(), flow) != used.end();
  return some && (flow != flow::name(flow::Kind::pair) || used.size() == 1);
}

Run describe(const ImpactCase& one, const impact::ContactImpact& impact, const std::string& flow) {
  Run run;
  run.ending = hybrid::name(impact.ending);
  run.reason = impact.message;
  run.flows = contact_flows(impact);
  run.admitted = flow == "auto" || admits(run.flows, flow);
  for (const auto& use : impact.flows) {
    run.steps += use.steps;
    run.rhs += use.rhs;
  }
  run.velocity = impact.velocity;
  for (double& v : run.velocity) v /= one.speed;
  run.icr = impact.icr;
  run.instants = instants_after_onset(impact, natural_time(one));
  return run;
}

/// With memory in place.
double seconds(const std::function<void()>& solve, double batch) {
  const double first = measuring::timed(solve);
  if (first > 10 * batch) return first;  // long enough to be measured by itself
  return measuring::least_seconds(solve, measuring::timed(solve), {batch, batches});
}

Run describe(const ImpactCase& one, const impact::BriefImpact& impact) {
  Run run{.ending = hybrid::name(impact.ending), .reason = impact.message};
  run.steps = impact.steps;
  run.rhs = impact.rhs;
  run.velocity = impact.velocity;
  for (double& v : run.velocity) v /= one.speed;
  run.icr = impact::correlation_ratios(impact.impulse);
  return run;
}

Run measure_briefly(const ImpactCase& one, const Request& request) {
  impact::ChainSolver solver;
  const auto balls = chain(one);
  const auto asked = options(one, request);
  auto run = describe(one, solver.solve(balls, asked));
  run.seconds = seconds([&] { solver.solve(balls, asked); }, request.batch);
  return run;
}

Run measure_fully(const ImpactCase& one, const Request& request) {
  const auto balls = chain(one);
  const auto asked = options(one, request);
  impact::ChainImpact impact;
  const double first = measuring::timed([&] { impact = impact::simulate(balls, asked); });
  auto run = describe(one, impact, request.flow);
  impact::ChainSolver solver;
  const auto solve = [&] { solver.solve(balls, asked); };
  run.seconds = run.admitted && request.batch > 0 ? seconds(solve, request.batch) : first;
  return run;
}

Run measure_packing(const ImpactCase& one, const Request& request) {
  const auto disks = packing(one);
  const auto asked = options(one, request);
  impact::NetworkImpact impact;
  const auto solve = [&] { impact = impact::simulate(disks, asked); };
  const double first = measuring::timed(solve);
  auto run = describe(one, impact, request.flow);
  run.seconds = request.batch > 0 ? seconds(solve, request.batch) : first;
  return run;
}

}  // namespace

Run measure(const ImpactCase& one, const Request& request) {
  try {
    if (one.side > 0) return measure_packing(one, request);
    return request.brief ? measure_briefly(one, request) : measure_fully(one, request);
  } catch (const std::exception& problem) {
    return {.ending = "failed", .reason = problem.what()};
  }
}

}  // namespace mariotte::stiffness_study
