#include "mariotte/impact/network/network_gate.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/impact/gate.hpp"

namespace mariotte::impact {

void pass_gate(const Configuration& before, double largest_rate, const std::vector<Index>& open,
               const std::vector<double>& noise_depth, NetworkImpact& impact) {
  const double share = balance_allowance * std::max(impact.requested_accuracy, 64 * epsilon);
  const auto& energy = impact.energy;
  const double reached =
      energy.initial + energy.final + energy.stored + std::abs(energy.work) + std::abs(energy.dissipated);
  double pull = 0, gain = 0, depth = 0, strongest = 0;
  for (const auto& contact : impact.contacts) {
    strongest = std::max(strongest, std::abs(contact.impulse));
    pull = std::max(pull, -contact.impulse);
    gain = std::max(gain, -contact.dissipated);
  }
  for (const Index j : open) {
    const double excess = -impact.gap[j] / noise_depth[j];
    depth = excess <= depth ? depth : excess;  // a gap that is not a number counts
  }
  double approach = 0;
  if (impact.ending == hybrid::Ending::separated)
    for (const double rate : gap_rates(before, impact.velocity)) approach = std::max(approach, -rate);
  const Balance balances[] = {
      {"an approach at the end", approach, share * largest_rate},
      {"the energy balance", energy.residual, share * reached},
      {"the momentum balance", impact.momentum_residual, share},
      {"an impulse that pulls", pull, share * strongest},
      {"the energy that a contact has gained", gain, share * reached},
      {"an indentation without force, relative to what cannot be told from rest,", depth, 1},
  };
  pass_gate(balances, impact.ending, impact.message);
}

}  // namespace mariotte::impact
