#include "mariotte/impact/network/network_gate.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/impact/unloaded_depth.hpp"

namespace mariotte::impact {

namespace {

double impulse(const NetworkOutcome& o, Index j) {
  return o.interval.after[o.layout.impulse[j]];
}

double rate(const NetworkOutcome& o, ConstState x, Index j) {
  return gap_rate(o.network.direction[j], x);
}

/// Gap rate before and after, without what drives prescribe: that is in their work.
double free_rates(const NetworkOutcome& o, Index j) {
  double sum = 0;
  for (const auto& [dof, coefficient] : o.network.direction[j])
    if (!model::prescribes(o.network.drive, dof))
      sum += coefficient * (o.interval.before[dof] + o.interval.after[dof]);
  return sum;
}

double given_impulse(const NetworkOutcome& o, Index k) {
  return integral(o.network.drive[k].signal, o.interval.time);
}

/// Fastest approach of a contact that is `among` those asked for.
template <class Among>
double approach(const NetworkOutcome& o, Among&& among) {
  double worst = 0;
  for (Index j = 0; j < o.network.contacts(); ++j)
    if (among(o.mode[j])) worst = std::max(worst, -rate(o, o.interval.after, j));
  return worst;
}

/// An energy balance, and the sum of what could be in it.
struct Energy {
  double residual = 0, reached = 0, gain = 0;
};

/// Impulses change the kinetic energy, less the work of walls, by Σ p_j (ġ_j⁻ + ġ_j⁺)/2, and those of given
/// forces likewise: the momentum balance is another matter.
Energy energy(const NetworkOutcome& o, const std::vector<ContactEnergy>& contacts) {
  const auto& d = o.network;
  Energy sum;
  for (Index j = 0; j < d.contacts(); ++j) {
    const double p = impulse(o, j), gap = o.interval.before[o.layout.gap[j]];
    const double initial = gap < 0 ? contact::stored_energy(d.law[j], -gap) : 0;
    const double work = 0.5 * p * free_rates(o, j);
    sum.residual += work + contacts[j].stored + contacts[j].dissipated - initial;
    sum.reached += initial + d.speed * (std::abs(p) + d.reduced_mass[j] * d.speed);
    sum.gain = std::max(sum.gain, gain(contacts[j]));
  }
  for (Index k = 0; k < o.layout.drives(); ++k) {
    const auto& drive = d.drive[k];
    const double done = o.interval.after[o.layout.drive_work[k]];
    sum.residual -= done;
    sum.reached += std::abs(done);
    if (drive.is_force)
      sum.residual +=
          0.5 * given_impulse(o, k) *
          (gap_rate(drive.direction, o.interval.before) + gap_rate(drive.direction, o.interval.after));
  }
  return sum;
}

}  // namespace

double NetworkGate::unexplained(const NetworkOutcome& o) {
  const auto& [before, after, time] = o.interval;
  change_.assign(o.layout.velocities(), 0.0);
  natural_.assign(o.layout.velocities(), 0.0);
  for (Index j = 0; j < o.network.contacts(); ++j)
    for (const auto& [dof, response] : o.network.response[j]) {
      change_[dof] += response * impulse(o, j);
      natural_[dof] +=
          std::abs(response) * (std::abs(impulse(o, j)) + o.network.reduced_mass[j] * o.network.speed);
    }
  for (Index k = 0; k < o.layout.drives(); ++k) {
    const auto& drive = o.network.drive[k];
    for (const auto& [dof, response] : drive.response) {
      change_[dof] += drive.is_force ? response * given_impulse(o, k) : after[dof] - before[dof];
      if (drive.is_force)
        natural_[dof] += std::abs(response) *
                         std::max(std::abs(given_impulse(o, k)), model::largest_integral(drive.signal, time));
    }
  }
  double worst = 0;
  for (Index i = 0; i < o.layout.velocities(); ++i) {
    const double apart = std::abs(after[i] - before[i] - change_[i]);
    if (apart == 0) continue;
    const double size = natural_[i] + std::abs(before[i]);  // 0 of a wall at rest
    const double part = apart / (size > 0 ? size : o.network.speed);
    worst = part <= worst ? worst : part;
  }
  return worst;
}

void NetworkGate::pass(const NetworkOutcome& o, double accuracy, hybrid::Ending& ending,
                       std::string& message) {
  const double share = balance_allowance * std::max(accuracy, 64 * epsilon);
  contact_energies(o.network, o.layout, o.mode, o.interval, energies_);
  const auto [residual, reached, gain] = energy(o, energies_);
  double pull = 0, strongest = 0;
  for (Index j = 0; j < o.network.contacts(); ++j) {
    strongest = std::max({strongest, std::abs(impulse(o, j)), o.network.reduced_mass[j] * o.network.speed});
    if (!contact::pulls(o.network.law[j])) pull = std::max(pull, -impulse(o, j));
  }
  const bool parts = ending == hybrid::Ending::separated;
  const Balance balances[] = {
      {"an approach at the end", approach(o, [&](auto mode) { return parts || is_slack(mode); }),
       share * o.network.speed},
      {"the energy balance, in units of the run,", residual, share * reached},
      {"the momentum balance, in units of the run,", unexplained(o), share},
      {"an impulse that pulls", pull, share * strongest},
      {"the energy that a contact has gained", gain, share * reached},
      {"an indentation without force, relative to what cannot be told from rest,",
       unloaded_depth(o.network, o.layout, o.mode, o.interval.after, accuracy), 1},
  };
  pass_gate(balances, ending, message);
}

}  // namespace mariotte::impact
