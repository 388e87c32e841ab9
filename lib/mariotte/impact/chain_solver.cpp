#include "mariotte/impact/chain_solver.hpp"

#include <cmath>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/course.hpp"
#include "mariotte/impact/impulses.hpp"

namespace mariotte::impact {

using model::ChainLayout;
using model::DimensionlessChain;

struct ChainSolver::Memory {
  model::ChainSystem system;
  hybrid::Workspace<model::ChainSystem> workspace;
  DimensionlessChain divided;
  ChainLayout divided_layout;
  std::vector<double> start;
  BriefImpact impact;

  void report(const DimensionlessChain& chain, const ChainLayout& layout, const model::Islands::Run& run) {
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

  void solve_whole(const model::Chain& chain, const hybrid::Options& options, bool stay) {
    system.reset(chain, options.accuracy, stay);
    initial_state(system.chain(), system.layout(), start);
    report(system.chain(), system.layout(),
           hybrid::simulate(system, start, hybrid::scaled(options, system.chain().scale), workspace));
    impact.widest = system.layout().contacts();
  }

  void solve_islands(const model::Chain& chain, const hybrid::Options& options, bool stay) {
    make_dimensionless(chain, options.accuracy, divided);
    const auto inner = tightened(options, chain.mass.size());
    fade_later(divided, inner.accuracy);
    make_layout(divided, divided_layout);
    initial_state(divided, divided_layout, start);
    model::Islands islands(divided, divided_layout, start, hybrid::scaled(inner, divided.scale), stay, {});
    islands.run();
    report(divided, divided_layout, islands.result());
    impact.widest = islands.count().widest;
  }
};

ChainSolver::ChainSolver() : memory_(std::make_unique<Memory>()) {}
ChainSolver::~ChainSolver() = default;

const BriefImpact& ChainSolver::solve(const model::Chain& chain, const hybrid::Options& options) {
  auto& m = *memory_;
  model::validate(chain);
  hybrid::validate(options);
  const bool stay = std::isfinite(options.max_time);
  divides(options, chain.mass.size()) ? m.solve_islands(chain, options, stay)
                                      : m.solve_whole(chain, tightened(options, chain.mass.size()), stay);
  return m.impact;
}

}  // namespace mariotte::impact
