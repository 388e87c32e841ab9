#include "mariotte/impact/network/network_balance.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/impact/laws/restitution.hpp"

namespace mariotte::impact {
namespace {

double wall_work(const model::Network& network, const Configuration& before,
                 const std::vector<double>& given) {
  if (before.mass.size() != given.size()) return 0;  // a full mass matrix has no walls
  double work = 0;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (std::isinf(before.mass[i]) && !model::prescribes(network.drive, static_cast<Index>(i)))
      work -= before.velocity[i] * given[i];
  return work;
}

}  // namespace

std::vector<double> impulses_of(const ContactImpact& impact) {
  std::vector<double> p;
  for (const auto& contact : impact.contacts) p.push_back(contact.impulse);
  return p;
}

EnergyBalance energy_balance(const model::Network& network, const Configuration& before,
                             const ContactImpact& impact, double drive_work) {
  EnergyBalance balance;
  balance.initial = kinetic_energy(before, before.velocity);
  balance.final = kinetic_energy(before, impact.velocity);
  for (std::size_t j = 0; j < network.law.size(); ++j)
    if (network.gap[j] < 0) balance.initial += contact::stored_energy(network.law[j], -network.gap[j]);
  for (const auto& contact : impact.contacts) {
    balance.stored += contact.stored;
    balance.dissipated += contact.dissipated;
    balance.plastic += contact.plastic;
    balance.adhesion += contact.adhesion;
  }
  balance.work = drive_work + wall_work(network, before, generalised_impulse(before, impulses_of(impact)));
  balance.residual = balance.final + balance.stored + balance.dissipated - balance.initial - balance.work;
  balance.ratio_lab =
      energy_ratio(kinetic_energy(before, impact.velocity), kinetic_energy(before, before.velocity));
  const auto relative = relative_energies(before, {impact.velocity, before.velocity});
  balance.ratio_centre = energy_ratio(relative[0], relative[1]);
  return balance;
}

double momentum_residual(const model::Network& network, const Configuration& before,
                         const ContactImpact& impact) {
  auto given = before;
  auto impulses = impulses_of(impact);
  for (const auto& drive : network.drive) {
    if (drive.quantity != model::Driven::force) continue;
    given.contact.push_back(drive.direction);
    impulses.push_back(integral(drive.signal, impact.time));
  }
  auto unexplained = velocity_change(given, impulses);
  for (std::size_t i = 0; i < unexplained.size(); ++i)
    unexplained[i] = impact.velocity[i] - before.velocity[i] - unexplained[i];
  const double energy =
      std::max(kinetic_energy(before, before.velocity), kinetic_energy(before, impact.velocity));
  return energy > 0 ? std::sqrt(kinetic_energy(before, unexplained) / energy) : 0;
}

}  // namespace mariotte::impact
