// A row of balls at rest: which force each contact carries, and how deep that makes it.
#pragma once
#include <vector>

#include "mariotte/model/chain/chain.hpp"

namespace mariotte::model {

/// Force of each contact at rest [N]. A ball rests on the next one towards which gravity draws it, and so on
/// down to a wall: contact j carries the weight of all balls above it, up to the next wall or the next gap
/// that is open, and `precompression` [N] besides. Balls without a wall below them fall and carry nothing.
/// Throws InvalidParameter for a precompression that is not finite and ≥ 0, or that nothing holds: walls at
/// both ends and no open gap do.
std::vector<double> static_forces(const Chain& chain, double precompression = 0);

/// Indents each contact so that it carries its force at rest, whatever its law: static equilibrium. Closed
/// gaps are replaced, and `precompressed` is set. Throws InvalidParameter as `static_forces`.
void put_at_rest(Chain& chain, double precompression = 0);

}  // namespace mariotte::model
