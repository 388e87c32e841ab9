#include "mariotte/impact/microbody/microbody_solver.hpp"

#include <algorithm>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/microbody/microbody_difference.hpp"
#include "mariotte/impact/microbody/microbody_gate.hpp"
#include "mariotte/impact/microbody/microbody_slowing.hpp"
#include "mariotte/impact/microbody/sphere_runs.hpp"
#include "mariotte/impact/promise.hpp"
#include "mariotte/model/microbody/microbody_system.hpp"

namespace mariotte::impact {

using model::MicrobodySystem;

namespace {

/// How often a tip has done so, as the automaton has said.
Index count(model::TipEvent event, const std::vector<hybrid::Timed<model::MicrobodyChange>>& changes) {
  return std::ranges::count(changes, event, [](const auto& one) { return one.change.event; });
}

}  // namespace

struct MicrobodySolver::Memory {
  Course course;
  hybrid::Workspace<MicrobodySystem> workspace;
  BriefMicrobodyImpact impact, looser;
  Passage gone;
  SphereRuns sphere;
  NaturalRoot natural_root;

  void report(const MicrobodySystem& system, ConstState start,
              const hybrid::Trajectory<model::MicrobodyChange>& run) {
    const auto& scale = system.body().scale;
    const auto& place = system.layout().place;
    const ConstState x = run.state;
    impact = {.ending = run.ending,
              .message = run.message,
              .time = run.time * scale.time,
              .attitude = quaternion_at(x, place.attitude),
              .velocity = scale.velocity * vector_at(x, place.velocity),
              .spin = (1 / scale.time) * system.mechanics().spin(x),
              .tip_velocity = scale.velocity * system.mechanics().tip(x, 0).velocity,
              .impacts = count(model::TipEvent::open, run.changes),
              .events = run.events,
              .estimated_accuracy = {}};
    gone = {.contacts = system.layout().tips,
            .harmless = single_impact,
            .periods = count(model::TipEvent::close, run.changes),
            .slowing = slowing(system, start, run)};
    for (const auto kind : flow::kinds) {
      const auto& flow = run.flows[static_cast<std::size_t>(kind)];
      impact.steps += flow.steps;
      impact.rhs += flow.rhs;
      count_flow(gone, kind, flow.phases, flow.steps);
    }
  }

  void solve(const model::Microbody& body, const hybrid::Options& options) {
    MicrobodySystem system(body, options.accuracy, /*balance=*/false, {.force_signs = false});
    const auto start = initial_state(system.body(), system.layout());
    auto run_options = hybrid::scaled(options, system.body().scale);
    run_options.accuracy = system.accuracy();
    const auto& run = hybrid::simulate(system, start, run_options, workspace);
    report(system, start, run);
    pass_gate(balances(system, start, run.state, workspace.mode), impact.ending, impact.message);
  }

  /// Null unless it is one that lanes can follow.
  const BriefMicrobodyImpact* solve_sphere(const model::Microbody& body, const hybrid::Options& options) {
    if (course == Course::of_simulate) return nullptr;
    const auto scene = sphere_scene(body, options, natural_root);
    if (!scene) return nullptr;
    sphere.clear();
    sphere.add(*scene, options.accuracy);
    sphere.follow();
    return sphere.result(0);
  }
};

MicrobodySolver::MicrobodySolver(Course course) : memory_(std::make_unique<Memory>()) {
  memory_->course = course;
}
MicrobodySolver::~MicrobodySolver() = default;

const BriefMicrobodyImpact& MicrobodySolver::solve(const model::Microbody& body,
                                                   const hybrid::Options& options) {
  auto& m = *memory_;
  model::validate(body);
  hybrid::validate(options);
  if (const auto* impact = m.solve_sphere(body, options)) return *impact;
  m.solve(body, options);
  const auto solve = [&](const model::Microbody& same, const hybrid::Options& tighter) {
    m.solve(same, tighter);
  };
  keep_promise(body, options, m.gone, m.impact, m.looser, solve, [&](const auto& a, const auto& b) {
    return difference(body, a.velocity - b.velocity, a.spin - b.spin);
  });
  return m.impact;
}

}  // namespace mariotte::impact
