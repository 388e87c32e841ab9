#include "mariotte/model/chain/chain_system.hpp"

#include "mariotte/model/contacts/topology_phase_members.hpp"

namespace mariotte::model {

template class TopologyPhase<ChainTopology>;
template class ContactSystem<ChainTopology>;

void ChainSystem::reset_parts() {
  make_layout(model_, layout_);
  phase_.reset();
}

void ChainSystem::reset(const Chain& chain, double accuracy, bool stay) {
  make_dimensionless(chain, accuracy, model_);
  reset_parts();
  stay_ = stay;
}

void ChainSystem::reset(const DimensionlessChain& whole, Index first, Index last, Index margin) {
  copy_slice(whole, first, last, model_);
  reset_parts();
  phase_.flows().set_edges({.left = first > 0, .right = last + 1 < std::ssize(whole.mass), .margin = margin});
  stay_ = true;
}

bool ChainSystem::is_over(const Mode& mode, ConstState x, bool impacted) const {
  if (model_.falls_back && (stay_ || !impacted)) return false;
  return ContactSystem::is_over(mode, x, impacted);
}

}  // namespace mariotte::model
