#include "mariotte/impact/energy.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/impact/laws/restitution.hpp"

namespace mariotte::impact {

using model::ChainLayout;
using model::DimensionlessChain;

namespace {

bool is_wall(const DimensionlessChain& chain, Index i) {
  return chain.inverse_mass[i] == 0;
}

/// Σ mᵢ (vᵢ − frame)ᵏ over the balls of finite mass.
template <class Power>
double sum_over_balls(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x,
                      Power&& power) {
  double sum = 0;
  for (Index i = 0; i < layout.velocities(); ++i)
    if (!is_wall(chain, i)) sum += chain.mass[i] * power(x[layout.velocity[i]]);
  return sum;
}

double mass(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x) {
  return sum_over_balls(chain, layout, x, [](double) { return 1.0; });
}
double momentum(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x) {
  return sum_over_balls(chain, layout, x, [](double v) { return v; });
}
double kinetic(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x, double frame = 0) {
  return 0.5 * sum_over_balls(chain, layout, x, [&](double v) { return (v - frame) * (v - frame); });
}

/// How far wall i has moved.
double wall_displacement(const DimensionlessChain& chain, const ChainLayout& layout, Index i,
                         const Interval& interval) {
  for (const auto& drive : chain.drive)
    for (const auto& [dof, coefficient] : drive.direction)
      if (dof == i) return coefficient * integral(drive.signal, interval.time);
  return interval.before[layout.velocity[i]] * interval.time;
}

double drive_work(const model::ContactLayout& layout, const Interval& interval) {
  double work = 0;
  for (const Index place : layout.drive_work) work += interval.after[place];
  return work;
}

double strength(const DimensionlessChain& chain) {
  return *std::max_element(chain.gravity.begin(), chain.gravity.end(),
                           [](double a, double b) { return std::abs(a) < std::abs(b); });
}

/// −γ Σ m Δx. A wall tells where the balls are; without one the mass centre falls in closed form.
double gravity_work(const DimensionlessChain& chain, const ChainLayout& layout, const Interval& interval) {
  const double gravity = strength(chain), t = interval.time;
  if (gravity == 0) return 0;
  Index wall = 0;
  while (wall < layout.velocities() && !is_wall(chain, wall)) ++wall;
  if (wall == layout.velocities()) {
    const double total = mass(chain, layout, interval.before);
    return -gravity * (momentum(chain, layout, interval.before) * t - 0.5 * total * gravity * t * t);
  }
  double displacement = wall_displacement(chain, layout, wall, interval), sum = 0;
  const double from_wall = displacement;
  const auto widening = [&](Index j) {
    return interval.after[layout.gap[j]] - interval.before[layout.gap[j]];
  };
  const auto add = [&](Index i) { sum += is_wall(chain, i) ? 0 : chain.mass[i] * displacement; };
  for (Index i = wall + 1; i < layout.velocities(); ++i) displacement += widening(i - 1), add(i);
  displacement = from_wall;
  for (Index i = wall - 1; i >= 0; --i) displacement -= widening(i), add(i);
  return -gravity * sum;
}

double wall_work(const DimensionlessChain& chain, const ChainLayout& layout, const std::vector<double>& p,
                 const Interval& interval) {
  double work = 0;
  for (Index i = 0; i < layout.velocities(); ++i) {
    if (!is_wall(chain, i) || model::prescribes(chain.drive, i)) continue;
    const double right = i < layout.contacts() ? p[i] : 0, left = i > 0 ? p[i - 1] : 0;
    work += interval.before[layout.velocity[i]] * (right - left);
  }
  return work;
}

double stored_at_start(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x) {
  double sum = 0;
  for (Index j = 0; j < layout.contacts(); ++j)
    if (x[layout.gap[j]] < 0) sum += contact::stored_energy(chain.law[j], -x[layout.gap[j]]);
  return sum;
}

void add_ratios(EnergyBalance& balance, const DimensionlessChain& chain, const ChainLayout& layout,
                const Interval& interval) {
  const auto ratio = [&](double frame_before, double frame_after) {
    return energy_ratio(kinetic(chain, layout, interval.after, frame_after),
                        kinetic(chain, layout, interval.before, frame_before));
  };
  balance.ratio_lab = ratio(0, 0);
  const bool walls = std::count(chain.inverse_mass.begin(), chain.inverse_mass.end(), 0.0) > 0;
  const double total = mass(chain, layout, interval.before);
  if (!walls)
    balance.ratio_centre = ratio(momentum(chain, layout, interval.before) / total,
                                 momentum(chain, layout, interval.after) / total);
}

}  // namespace

namespace {

/// What memory tells of a contact whose law has branches.
ContactEnergy remembered(const contact::BranchedLaw& law, const contact::Memory& past,
                         contact::ContactMode mode, double before, double now) {
  ContactEnergy energy;
  energy.adhesion = past.adhesion_loss;
  if (contact::carries_force(mode)) energy.stored = law.stored_energy(past, now);
  contact::Memory start;  // a contact that starts indented has yielded before
  if (before > law.yield_indentation(start)) start.peak = before;
  energy.plastic = plastic_loss(law, past, now) - plastic_loss(law, start, before);
  energy.dent = law.closing_indentation(past);
  return energy;
}

}  // namespace

ContactEnergy contact_energy(const model::ScaledContacts& contacts, const model::ContactLayout& layout,
                             const contact::ContactSet& mode, const Interval& interval, Index j) {
  ContactEnergy energy;
  const Index at = layout.gap[j];
  const double gap = interval.after[at];
  if (const auto* branches = contact::branched(contacts.law[j]))
    energy = remembered(*branches, model::memory_of(mode, j), mode[j], -interval.before[at], -gap);
  else if (contact::carries_force(mode[j]) && gap < 0)
    energy.stored = contact::stored_energy(contacts.law[j], -gap);
  if (layout.work[j] != ChainLayout::absent)
    energy.dissipated = interval.after[layout.work[j]] - energy.stored;
  return energy;
}

void contact_energies(const model::ScaledContacts& contacts, const model::ContactLayout& layout,
                      const contact::ContactSet& mode, const Interval& interval,
                      std::vector<ContactEnergy>& energies) {
  energies.clear();
  for (Index j = 0; j < layout.contacts(); ++j)
    energies.push_back(contact_energy(contacts, layout, mode, interval, j));
}

EnergyBalance energy_balance(const DimensionlessChain& chain, const ChainLayout& layout,
                             const std::vector<ContactEnergy>& contacts, const std::vector<double>& p,
                             const Interval& interval) {
  EnergyBalance balance;
  balance.initial = kinetic(chain, layout, interval.before) + stored_at_start(chain, layout, interval.before);
  balance.final = kinetic(chain, layout, interval.after);
  balance.work = gravity_work(chain, layout, interval) + wall_work(chain, layout, p, interval) +
                 drive_work(layout, interval);
  for (const auto& energy : contacts) {
    balance.stored += energy.stored;
    balance.dissipated += energy.dissipated;
    balance.plastic += energy.plastic;
    balance.adhesion += energy.adhesion;
  }
  balance.residual = balance.final + balance.stored + balance.dissipated - balance.initial - balance.work;
  add_ratios(balance, chain, layout, interval);
  return balance;
}

MomentumBalance momentum_balance(const DimensionlessChain& chain, const ChainLayout& layout,
                                 const Interval& interval) {
  MomentumBalance balance;
  balance.initial = momentum(chain, layout, interval.before);
  balance.final = momentum(chain, layout, interval.after);
  double given = -mass(chain, layout, interval.before) * strength(chain) * interval.time;
  for (Index i = 0; i < layout.velocities(); ++i) {
    if (!is_wall(chain, i)) continue;
    if (i < layout.contacts()) given += interval.after[layout.impulse[i]];
    if (i > 0) given -= interval.after[layout.impulse[i - 1]];
  }
  for (const auto& drive : chain.drive)
    if (drive.is_force)
      for (const auto& term : drive.direction)
        given += term.coefficient * integral(drive.signal, interval.time);
  balance.residual = balance.final - balance.initial - given;
  return balance;
}

EnergyBalance in_units(EnergyBalance balance, const Scale& scale) {
  for (double* entry : {&balance.initial, &balance.final, &balance.stored, &balance.dissipated,
                        &balance.plastic, &balance.adhesion, &balance.work, &balance.residual})
    *entry *= scale.energy();
  return balance;
}

MomentumBalance in_units(MomentumBalance balance, const Scale& scale) {
  for (double* entry : {&balance.initial, &balance.final, &balance.residual}) *entry *= scale.momentum();
  return balance;
}

}  // namespace mariotte::impact
