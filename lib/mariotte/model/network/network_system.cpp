#include "mariotte/model/network/network_system.hpp"

#include "mariotte/model/contacts/topology_phase_members.hpp"

namespace mariotte::model {

template class TopologyPhase<NetworkTopology>;
template class ContactSystem<NetworkTopology>;

void NetworkSystem::reset(const Network& network, double accuracy, bool stay) {
  make_dimensionless(network, accuracy, model_);
  make_layout(model_, layout_);
  phase_.reset();
  stay_ = stay;
}

}  // namespace mariotte::model
