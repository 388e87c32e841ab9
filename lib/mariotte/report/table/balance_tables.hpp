// The lower half of the table of a run: what was conserved.
#pragma once
#include <string>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"

namespace mariotte::report {

/// The energy balance; its residual also relative to the energy put in.
std::string energy_table(const impact::ChainImpact& impact);
std::string energy_table(const impact::NetworkImpact& impact);

/// The momentum balance; its residual also relative to Σ m |v| of the balls of finite mass at the start.
std::string momentum_table(const impact::ChainImpact& impact, const model::Chain& chain);

/// Of a network, whose momenta differ in kind, only how well the impulses explain the velocities.
std::string momentum_table(const impact::NetworkImpact& impact);

}  // namespace mariotte::report
