// `[chain]`: a chain of balls, resolved to SI.
#pragma once
#include "mariotte/impact/validity.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

struct ResolvedChain {
  model::Chain chain;
  std::vector<double> radius;  ///< n values [m], infinite for planes; empty unless every ball has one
  std::vector<impact::Touching> touching;  ///< as in `Scene`
  bool at_rest = false;                    ///< starts in static equilibrium
};

/// Throws SceneError; warns of what looks like a slip. `gravity` is what [run] says of it, if anything.
ResolvedChain read_chain(Source& source, const Field& chain, const std::optional<Field>& gravity);

}  // namespace mariotte::scene
