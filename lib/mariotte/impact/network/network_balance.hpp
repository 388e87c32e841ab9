// Balances of a network, which must balance in every run.
#pragma once
#include "mariotte/impact/laws/configuration.hpp"
#include "mariotte/impact/network/network_impact.hpp"

namespace mariotte::impact {

/// From velocities, impulses, stored and dissipated energies of the impact. `work` is that of moving walls,
/// v · Gᵀp; `ratio_centre` compares relative energies, so walls do no harm.
EnergyBalance energy_balance(const model::Network& network, const Configuration& before,
                             const ContactImpact& impact, double drive_work);

/// What Gᵀp and given forces do not explain of the change of the velocities: √(T(v⁺ − v⁻ − M⁻¹Gᵀp)/T), T the
/// larger of the kinetic energies before and after.
double momentum_residual(const model::Network& network, const Configuration& before,
                         const ContactImpact& impact);

/// p of all contacts.
std::vector<double> impulses_of(const ContactImpact& impact);

}  // namespace mariotte::impact
