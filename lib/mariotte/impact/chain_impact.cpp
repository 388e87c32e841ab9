#include "mariotte/impact/chain_impact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/chain_solver.hpp"
#include "mariotte/impact/energy.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/peaks.hpp"
#include "mariotte/impact/trace.hpp"
#include "mariotte/model/chain_system.hpp"

namespace mariotte::impact {

using model::ChainSystem;
using Run = hybrid::Trajectory<ChainSystem::Change>;

namespace {

/// Hands every step to those who look at it.
class Observers final : public hybrid::PhaseWatcher {
 public:
  Observers(const model::ChainPhase& phase, const ChainSystem& system, bool trace)
      : peaks(phase, system.layout()), recorder(phase, system.chain(), system.layout()), trace_(trace) {}
  void begin_phase(double time, ConstState) override { start_ = time; }
  void watch(const flow::Step& step) override {
    peaks.watch(step);
    if (trace_) recorder.watch(start_, step);
  }

  PeakWatcher peaks;
  TraceRecorder recorder;

 private:
  bool trace_;
  double start_ = 0;
};

bool ends_force(const model::ContactChange& change) {
  return contact::carries_force(change.before) && !contact::carries_force(change.after);
}

/// Changes of one instant become one event; those that leave every force as it is become none.
std::vector<Event> events(const Run& run, double unit) {
  std::vector<Event> list;
  for (const auto& [time, change] : run.changes) {
    if (!starts_force(change) && !ends_force(change)) continue;
    if (list.empty() || list.back().time != time * unit)
      list.push_back({.time = time * unit, .open = {}, .close = {}});
    (starts_force(change) ? list.back().close : list.back().open).push_back(change.contact);
  }
  for (auto& event : list) {
    std::sort(event.open.begin(), event.open.end());
    std::sort(event.close.begin(), event.close.end());
  }
  return list;
}

void add_periods(std::vector<ContactHistory>& contacts, const Run& run, double unit) {
  for (const auto& [time, change] : run.changes) {
    auto& periods = contacts[change.contact].periods;
    if (starts_force(change)) periods.push_back({.start = time * unit, .end = std::nullopt});
    if (ends_force(change)) periods.back().end = time * unit;
  }
}

std::vector<FlowUse> flow_uses(const Run& run) {
  std::vector<FlowUse> uses;
  for (const auto kind : flow::kinds) {
    const auto& count = run.flows[static_cast<std::size_t>(kind)];
    if (count.phases > 0)
      uses.push_back({std::string(flow::name(kind)), count.phases, count.steps, count.rhs});
  }
  return uses;
}

std::vector<Skipped> skipped(const ChainSystem& system, const Run& run, bool trace) {
  const auto none = [](const std::vector<Index>& places) {
    return std::all_of(places.begin(), places.end(), [](Index p) { return p == model::ChainLayout::absent; });
  };
  const auto used = [&](flow::Kind kind) { return run.flows[static_cast<std::size_t>(kind)].phases; };
  std::vector<Skipped> list;
  if (const Index flights = used(flow::Kind::ballistic))
    list.push_back({"free flight", std::to_string(flights) + " phases in closed form, not integrated"});
  if (const Index pairs = used(flow::Kind::pair))
    list.push_back({"single contacts", std::to_string(pairs) + " phases in closed form, not integrated"});
  if (const Index modal = used(flow::Kind::modal))
    list.push_back({"linear contacts", std::to_string(modal) + " phases by natural modes, not integrated"});
  if (none(system.layout().work)) list.push_back({"dissipation", "no contact is damped"});
  if (none(system.layout().impulse))
    list.push_back({"impulse integrals", "momentum gives every impulse of a chain without walls"});
  if (used(flow::Kind::cvode_bdf_dense) + used(flow::Kind::cvode_bdf_band) +
          used(flow::Kind::cvode_bdf_klu) ==
      0)
    list.push_back({"Newton iteration", "no phase was followed implicitly"});
  if (!trace) list.push_back({"trace", "not asked for"});
  return list;
}

/// A loss is a difference of two integrals; below the accuracy asked for its sign means nothing.
double loss_above(double noise, double loss) {
  return loss < 0 && loss > -noise ? 0 : loss;
}

std::vector<ContactHistory> histories(const ChainSystem& system, const Run& run, const std::vector<double>& p,
                                      const std::vector<ContactEnergy>& energies,
                                      const std::vector<Peak>& peaks, double accuracy) {
  const auto& scale = system.chain().scale;
  const double speed = system.chain().speed;
  std::vector<ContactHistory> contacts(system.layout().contacts());
  for (std::size_t j = 0; j < contacts.size(); ++j)
    contacts[j] = {.impulse = p[j] * scale.momentum(),
                   .peak_force = peaks[j].force * scale.force(),
                   .peak_indentation = peaks[j].indentation * scale.length,
                   .stored = energies[j].stored * scale.energy(),
                   .dissipated = loss_above(accuracy * system.chain().reduced_mass[j] * speed * speed,
                                            energies[j].dissipated) *
                                 scale.energy(),
                   .periods = {}};
  add_periods(contacts, run, scale.time);
  return contacts;
}

}  // namespace

ChainImpact simulate(const model::Chain& chain, const hybrid::Options& options, bool trace) {
  model::validate(chain);
  hybrid::validate(options);
  ChainSystem system;
  system.reset(chain, options.accuracy, /*stay=*/std::isfinite(options.max_time));
  std::vector<double> start, p;
  std::vector<Index> periods;
  initial_state(system.chain(), system.layout(), start);
  Observers observers(system.phase(), system, trace);
  hybrid::Workspace<ChainSystem> workspace;
  const Run& run =
      hybrid::simulate(system, start, hybrid::scaled(options, system.chain().scale), workspace, &observers);

  const auto& scale = system.chain().scale;
  const Stretch stretch{.before = start, .after = run.state, .time = run.time};
  impulses(system.chain(), system.layout(), stretch, p);
  count_periods(run.changes, system.layout().contacts(), periods);
  clear_untouched(periods, p);
  system.problem(workspace.mode);  // forces at the ending are those of the last mode
  const auto energies = contact_energies(system.chain(), system.layout(), workspace.mode, stretch);

  ChainImpact impact;
  impact.ending = run.ending;
  impact.message = run.message;
  impact.time = run.time * scale.time;
  for (const Index at : system.layout().velocity) impact.velocity.push_back(run.state[at] * scale.velocity);
  for (const Index at : system.layout().gap) impact.gap.push_back(run.state[at] * scale.length);
  impact.contacts = histories(system, run, p, energies, observers.peaks.peaks(), options.accuracy);
  impact.icr = correlation_ratios(p);
  impact.impulse_direction = direction(p);
  impact.events = events(run, scale.time);
  impact.energy = energy_ledger(system.chain(), system.layout(), energies, p, stretch);
  impact.momentum = momentum_ledger(system.chain(), system.layout(), stretch);
  impact.flows = flow_uses(run);
  impact.skipped = skipped(system, run, trace);
  impact.requested_accuracy = options.accuracy;
  if (trace) impact.trace = observers.recorder.take(run.time, run.state);
  return impact;
}

double estimate_accuracy(const model::Chain& chain, const hybrid::Options& options,
                         const ChainImpact& result) {
  auto tighter = options;
  tighter.accuracy = std::max(1e-2 * options.accuracy, 16 * epsilon);
  ChainSolver solver;
  const auto& reference = solver.solve(chain, tighter);
  double error = 0, speed = 0;
  for (std::size_t i = 0; i < chain.velocity.size(); ++i) {
    error = std::max(error, std::abs(result.velocity[i] - reference.velocity[i]));
    speed = std::max(speed, std::abs(chain.velocity[i]));
  }
  return speed > 0 ? error / speed : error;
}

}  // namespace mariotte::impact
