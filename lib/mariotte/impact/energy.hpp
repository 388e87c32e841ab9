// Balances: energy and momentum that must balance in every run.
#pragma once
#include <algorithm>

#include "mariotte/contact/contact_set.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/impulses.hpp"

namespace mariotte::impact {

/// Elastic energy and losses of one contact, dimensionless.
struct ContactEnergy {
  double stored = 0;
  double dissipated = 0;  ///< work put in less what is stored, and what a slack contact still holds
  double plastic = 0;     ///< of it, by yielding
  double adhesion = 0;    ///< of it, where adhesion snapped in and gave way
  double dent = 0;        ///< indentation at which the contact closes again [length]
};
/// By how much one of the losses is below zero: all of them, yielding, adhesion, and what is left for
/// dampers.
inline double gain(const ContactEnergy& e) {
  return -std::min({e.dissipated, e.plastic, e.adhesion, e.dissipated - e.plastic - e.adhesion});
}
/// Of contact j.
ContactEnergy contact_energy(const model::ScaledContacts& contacts, const model::ContactLayout& layout,
                             const contact::ContactSet& mode, const Interval& interval, Index j);

/// `mode` is the contact set at the end of the interval. Fills `energies`, whose memory is reused.
void contact_energies(const model::ScaledContacts& contacts, const model::ContactLayout& layout,
                      const contact::ContactSet& mode, const Interval& interval,
                      std::vector<ContactEnergy>& energies);

/// Both balances, dimensionless; `p` are the dimensionless impulses.
EnergyBalance energy_balance(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                             const std::vector<ContactEnergy>& contacts, const std::vector<double>& p,
                             const Interval& interval);
/// Momentum of the balls over the interval.
MomentumBalance momentum_balance(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                                 const Interval& interval);

/// A dimensionless balance in the units of the scale.
EnergyBalance in_units(EnergyBalance balance, const Scale& scale);
MomentumBalance in_units(MomentumBalance balance, const Scale& scale);

}  // namespace mariotte::impact
