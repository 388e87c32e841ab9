// Ledgers: energy and momentum that must balance in every run.
#pragma once
#include "mariotte/contact/contact_set.hpp"
#include "mariotte/impact/chain_impact.hpp"
#include "mariotte/impact/impulses.hpp"

namespace mariotte::impact {

/// Elastic energy and loss of one contact, dimensionless.
struct ContactEnergy {
  double stored = 0;
  double dissipated =
      0;  ///< work put in less what is stored; what a slack contact still holds counts as lost
};

/// `mode` is the contact set at the end of the stretch.
std::vector<ContactEnergy> contact_energies(const model::DimensionlessChain& chain,
                                            const model::ChainLayout& layout, const contact::ContactSet& mode,
                                            const Stretch& stretch);

/// Both ledgers in the chain's own units; `p` are the dimensionless impulses.
EnergyLedger energy_ledger(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                           const std::vector<ContactEnergy>& contacts, const std::vector<double>& p,
                           const Stretch& stretch);
/// Momentum of the balls over the stretch, in the chain's own units.
MomentumLedger momentum_ledger(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                               const Stretch& stretch);

}  // namespace mariotte::impact
