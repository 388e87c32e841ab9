#include "mariotte/impact/chain/chain_solver.hpp"

#include <cmath>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/brief_run.hpp"
#include "mariotte/impact/chain/chain_frame.hpp"
#include "mariotte/impact/chain/chain_gate.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/row_runs.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/watch/chain_run.hpp"

namespace mariotte::impact {

using model::ChainLayout;
using model::DimensionlessChain;

struct ChainSolver::Memory {
  Course course;
  model::ChainSystem system;
  hybrid::Workspace<model::ChainSystem> workspace;
  DimensionlessChain divided;
  ChainLayout divided_layout;
  std::vector<double> start;
  std::vector<ContactEnergy> energies;
  model::Chain moving;
  BriefImpact impact, looser;
  Passage gone;
  TripletRuns triplet{flow::make_triplet_lanes(flow::Lanewise::contacts)};
  NaturalRoot natural_root;

  void report(const DimensionlessChain& chain, const ChainLayout& layout, const model::Islands::Run& run,
              const contact::ContactSet& mode, double accuracy) {
    const Interval interval{.before = start, .after = run.state, .time = run.time};
    describe(run, layout, chain.scale, impact);
    impulses(chain, layout, interval, impact.impulse);
    count_periods(run.changes, layout.contacts(), impact.periods);
    contact_energies(chain, layout, mode, interval, energies);
    pass_gate({chain, layout, mode, interval, impact.impulse, impact.periods, energies}, accuracy,
              impact.ending, impact.message);
    clear_faint(chain, impact.periods, impact.impulse);
    for (double& p : impact.impulse) p *= chain.scale.momentum();
    gone = passage(run, impact.periods, chain.law);
  }

  /// Past events where that is quicker. A phase that fails after one cannot begin anew: then the run does.
  const model::Islands::Run& simulate(const hybrid::Options& options) {
    for (const bool passes : {course == Course::quickest, false}) {
      workspace.passes_events = passes;
      const auto& run = hybrid::simulate(system, start, options, workspace);
      if (!passes || run.ending != hybrid::Ending::failed) break;
    }
    return workspace.run;
  }

  void solve_whole(const model::Chain& chain, const hybrid::Options& options, bool stay) {
    system.reset(chain, options.accuracy, stay);
    initial_state(system.chain(), system.layout(), start);
    const auto& run = simulate(hybrid::scaled(options, system.chain().scale));
    report(system.chain(), system.layout(), run, workspace.mode, options.accuracy);
    gone.slowing = slowing(system, workspace.mode, run, chain.law);
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
    report(divided, divided_layout, islands.result(), islands.mode(), options.accuracy);
    impact.widest = islands.count().widest;
  }

  void solve(const model::Chain& chain, const hybrid::Options& options) {
    const bool stay = std::isfinite(options.max_time);
    const auto balls = chain.mass.size();
    divides(options, chain) ? solve_islands(chain, options, stay)
                            : solve_whole(chain, tightened(options, balls), stay);
  }

  /// Null unless it is one that lanes can follow.
  const BriefImpact* solve_triplet(const model::Chain& chain, const hybrid::Options& options) {
    if (course == Course::of_simulate) return nullptr;
    const auto scene = row_scene<3>(chain, options, natural_root);
    if (!scene) return nullptr;
    triplet.clear();
    triplet.add(*scene, options.accuracy);
    triplet.follow();
    return triplet.result(0);
  }

  void run(const model::Chain& chain, const hybrid::Options& options) {
    chain.drive.empty() ? keep_promise(chain, options)
                        : keep_promise(with_reached_speeds(chain, options), options);
  }

  void keep_promise(const model::Chain& chain, const hybrid::Options& options) {
    solve(chain, options);
    const auto again = [&](const model::Chain& same, const hybrid::Options& tighter) {
      solve(same, tighter);
    };
    const double speed = reference_speed(chain);
    impact::keep_promise(chain, options, gone, impact, looser, again, [&](const auto& a, const auto& b) {
      return difference(a.velocity, b.velocity, speed, chain.drive);
    });
    add_rounding(gone, chain, options.accuracy, impact.estimated_accuracy);
  }
};

ChainSolver::ChainSolver(Course course) : memory_(std::make_unique<Memory>()) {
  memory_->course = course;
}
ChainSolver::~ChainSolver() = default;

const BriefImpact& ChainSolver::solve(const model::Chain& chain, const hybrid::Options& options) {
  auto& m = *memory_;
  model::validate(chain);
  hybrid::validate(options);
  model::expect_end(chain, options.max_time);
  if (const auto* impact = m.solve_triplet(chain, options)) return *impact;
  const auto frame = moving_frame(chain);
  if (!frame) {
    m.run(chain, options);
  } else {
    m.moving = chain;
    enter(frame, m.moving.velocity);
    m.run(m.moving, options);
    leave(frame, m.impact);
  }
  return m.impact;
}

}  // namespace mariotte::impact
