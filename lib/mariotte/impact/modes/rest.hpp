// Contacts at rest: the forces they carry in static equilibrium, and how stiff that makes them.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::impact {

/// Of m contacts in static equilibrium. Dampers do not matter here.
struct Rest {
  std::vector<double> force;        ///< F_j [N]
  std::vector<double> indentation;  ///< δ_j, at which contact j carries it [m]
  std::vector<double> stiffness;    ///< ∂F_j/∂δ_j there [N/m]
};

/// The rest of a row. With `end_force` [N] all contacts carry it, and the weight of what stands on them
/// [static_forces]. Without, walls hold the row: between two of them the gaps at the start say by how much it
/// is shortened, on one it stands by its weight. Throws InvalidParameter where a contact is open at rest,
/// carries no force, or would yield.
Rest rest(const model::Chain& chain, std::optional<double> end_force = {});

/// The rest of a network that starts precompressed: the least of its elastic energy, by Newton's method from
/// the start. Throws InvalidParameter as above, and if none is found.
Rest rest(const model::Network& network);

}  // namespace mariotte::impact
