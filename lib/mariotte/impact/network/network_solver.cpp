#include "mariotte/impact/network/network_solver.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/brief_run.hpp"
#include "mariotte/impact/network/network_frame.hpp"
#include "mariotte/impact/network/network_gate.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/impact/network/network_run.hpp"
#include "mariotte/model/network/network_system.hpp"

namespace mariotte::impact {

struct NetworkSolver::Memory {
  model::NetworkSystem system;
  hybrid::Workspace<model::NetworkSystem> workspace;
  NetworkGate gate;
  model::Network moving;
  std::vector<double> start;
  BriefImpact impact, looser;
  Passage gone;

  /// Contacts that touched at rest and were let go before they left the noise have had no period.
  void report_contacts(const ContactRun& run, double accuracy) {
    const auto& d = system.network();
    const auto& at = system.layout();
    count_periods(run.changes, at.contacts(), impact.periods);
    for (const auto& [time, change] : run.changes)
      if (change.before == contact::ContactMode::touching &&
          !is_felt(d, change.contact, run.state[at.impulse[change.contact]], accuracy))
        --impact.periods[change.contact];
    impact.impulse.clear();
    for (const Index place : at.impulse) impact.impulse.push_back(run.state[place]);
    clear_faint(d, impact.periods, impact.impulse);
    for (double& p : impact.impulse) p *= d.scale.momentum();
  }

  void solve(const model::Network& network, const hybrid::Options& options) {
    system.reset(network, options.accuracy, /*stay=*/std::isfinite(options.max_time));
    const auto& d = system.network();
    initial_state(d, system.layout(), start);
    const auto& run = hybrid::simulate(system, start, hybrid::scaled(options, d.scale), workspace);
    describe(run, system.layout(), d.scale, impact);
    report_contacts(run, options.accuracy);
    gate.pass({d, system.layout(), workspace.mode, {start, run.state, run.time}}, options.accuracy,
              impact.ending, impact.message);
    gone = passage(run, impact.periods, d.law);
    gone.slowing = slowing(system, workspace.mode, run, d.law);
    impact.widest = system.layout().contacts();
  }

  void run(const model::Network& network, const hybrid::Options& options) {
    network.drive.empty() ? keep_promise(network, options)
                          : keep_promise(with_reached_speeds(network, options), options);
  }

  void keep_promise(const model::Network& network, const hybrid::Options& options) {
    solve(network, options);
    const auto again = [&](const model::Network& same, const hybrid::Options& tighter) {
      solve(same, tighter);
    };
    impact::keep_promise(network, options, gone, impact, looser, again, [&](const auto& a, const auto& b) {
      return rate_difference(network, reference_speed(network), a.velocity, b.velocity);
    });
    add_rounding(gone, network, options.accuracy, impact.estimated_accuracy);
  }
};

NetworkSolver::NetworkSolver() : memory_(std::make_unique<Memory>()) {}
NetworkSolver::~NetworkSolver() = default;

const BriefImpact& NetworkSolver::solve(const model::Network& network, const hybrid::Options& options) {
  auto& m = *memory_;
  model::validate(network);
  hybrid::validate(options);
  model::expect_end(network, options.max_time);
  const auto frame = moving_frame(network);
  if (!frame) {
    m.run(network, options);
  } else {
    m.moving = network;
    enter(frame, m.moving.velocity);
    m.run(m.moving, options);
    leave(frame, m.impact.velocity);
  }
  return m.impact;
}

}  // namespace mariotte::impact
