// Balances: energy and momentum that must balance in every run.
#pragma once
#include "mariotte/contact/contact_set.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/impulses.hpp"

namespace mariotte::impact {

/// Elastic energy and loss of one contact, dimensionless.
struct ContactEnergy {
  double stored = 0;
  double dissipated = 0;  ///< work put in less what is stored, and what a slack contact still holds
};

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
