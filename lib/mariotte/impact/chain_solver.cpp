#include "mariotte/impact/chain_solver.hpp"

#include <cmath>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/model/chain_system.hpp"

namespace mariotte::impact {

struct ChainSolver::Memory {
  model::ChainSystem system;
  hybrid::Workspace<model::ChainSystem> workspace;
  std::vector<double> start;
  BriefImpact impact;

  void report(const hybrid::Trajectory<model::ContactChange>& run) {
    const auto& chain = system.chain();
    const auto& layout = system.layout();
    impact.ending = run.ending;
    impact.message = run.message;
    impact.time = run.time * chain.scale.time;
    impact.velocity.clear();
    for (const Index at : layout.velocity) impact.velocity.push_back(run.state[at] * chain.scale.velocity);
    impulses(chain, layout, {.before = start, .after = run.state, .time = run.time}, impact.impulse);
    count_periods(run.changes, layout.contacts(), impact.periods);
    clear_untouched(impact.periods, impact.impulse);
    for (double& p : impact.impulse) p *= chain.scale.momentum();
    impact.events = run.events;
    impact.steps = impact.rhs = 0;
    for (const auto& flow : run.flows) {
      impact.steps += flow.steps;
      impact.rhs += flow.rhs;
    }
  }
};

ChainSolver::ChainSolver() : memory_(std::make_unique<Memory>()) {}
ChainSolver::~ChainSolver() = default;

const BriefImpact& ChainSolver::solve(const model::Chain& chain, const hybrid::Options& options) {
  auto& m = *memory_;
  model::validate(chain);
  hybrid::validate(options);
  m.system.reset(chain, options.accuracy, /*stay=*/std::isfinite(options.max_time));
  initial_state(m.system.chain(), m.system.layout(), m.start);
  m.report(hybrid::simulate(m.system, m.start, hybrid::scaled(options, m.system.chain().scale), m.workspace));
  return m.impact;
}

}  // namespace mariotte::impact
