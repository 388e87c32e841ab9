// A chain as a hybrid system.
#pragma once
#include "mariotte/model/chain/chain_layout.hpp"
#include "mariotte/model/chain/chain_topology.hpp"
#include "mariotte/model/contacts/contact_system.hpp"

namespace mariotte::model {

using ChainState = ContactState<ChainTopology>;
using ChainPhase = TopologyPhase<ChainTopology>;
extern template class TopologyPhase<ChainTopology>;
extern template class ContactSystem<ChainTopology>;

/// `chain().scale` leads back to the units of the scene.
class ChainSystem : public ContactSystem<ChainTopology> {
 public:
  ChainSystem() = default;
  /// Become the system of another chain and reuse the memory. `stay` keeps a chain that gravity leads back to
  /// a wall going after its first impact.
  void reset(const Chain& chain, double accuracy, bool stay);
  /// Become the system of balls `first` to `last` of a chain; its phases end where a row of touching contacts
  /// is about to push beyond them, `margin` contacts before it does.
  void reset(const DimensionlessChain& whole, Index first, Index last, Index margin);
  const DimensionlessChain& chain() const { return model_; }

  /// Where gravity leads back to a wall, which it cannot in a network: the end of the first impact.
  bool is_over(const Mode& mode, ConstState x, bool impacted) const;

 private:
  void reset_parts();
};

}  // namespace mariotte::model
