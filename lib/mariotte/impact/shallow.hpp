// Whether the energy at a start suffices to indent a body by more than its radius.
#pragma once
#include <span>

#include "mariotte/impact/validity.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::impact {

/// True if no run can end `invalid`: each contact would have to store more than there is, kinetic energy and
/// what is stored at the start. False where that is not plain at once: with gravity, walls that move, and
/// laws that are no power laws. Quick solvers, which know no indentations, may then be asked.
bool stays_shallow(const model::Chain& chain, std::span<const Touching> touching);
bool stays_shallow(const model::Network& network, std::span<const Touching> touching);
bool stays_shallow(const model::Microbody& body, std::span<const Touching> touching);
/// Bodies with friction are always run as a whole, which tells.
inline bool stays_shallow(const model::Bodies&, std::span<const Touching>) {
  return false;
}

}  // namespace mariotte::impact
