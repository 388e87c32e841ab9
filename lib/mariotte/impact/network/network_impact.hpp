// The impact of a contact network, in the network's units.
#pragma once
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/laws/configuration.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::impact {

/// `icr` has ratios of contacts that follow each other in the network, which need not be neighbours; results
/// tell the direction of the impulses instead.
struct NetworkImpact : ContactImpact {
  /// Largest angle by which the direction of a closed contact of balls would have turned [rad]; directions
  /// are kept. Empty for other dofs.
  std::optional<double> turning;
  /// Balls, from 0, that fly towards each other after the run though no contact is between them.
  std::vector<std::pair<Index, Index>> missed = {};
  double momentum_residual = 0;  ///< of v⁺ − v⁻ = M⁻¹Gᵀp, relative, in the norm of the kinetic energy
};

/// Simulate a network until it separates for good, or a limit. Throws InvalidParameter for a network,
/// accuracy or flow that makes no sense, and for samplings of what does not exist.
NetworkImpact simulate(const model::Network& network, const hybrid::Options& options = {},
                       const RunObserver& observers = {});

/// A driven network that knows which speeds are reached until the end of a run.
model::Network with_reached_speeds(const model::Network& network, const hybrid::Options& options);

/// Error of the gap rates that follow from `result.velocity`, relative to the reference speed, from a second
/// run at a tighter accuracy and, of up to 200 contacts, one by a flow that shares no formula.
double estimate_accuracy(const model::Network& network, const hybrid::Options& options,
                         const NetworkImpact& result);

/// What a velocity of the network is of, and its unit: a coordinate of a ball [m/s], or any degree of
/// freedom, whose unit is not known.
inline const char* moving(const model::Network& network) {
  return network.dimension > 0 ? "coordinate" : "degree of freedom";
}
/// Unit of such a velocity; empty if it is not known.
inline const char* velocity_unit(const model::Network& network) {
  return network.dimension > 0 ? "m/s" : "";
}

/// The network at its start, as impact laws see it.
Configuration configuration_of(const model::Network& network);

}  // namespace mariotte::impact
