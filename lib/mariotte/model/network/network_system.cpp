#include "mariotte/model/network/network_system.hpp"

#include "mariotte/model/contacts/topology_phase_members.hpp"

namespace mariotte::model {

template class TopologyPhase<NetworkTopology>;
template class ContactSystem<NetworkTopology>;

NetworkSystem::NetworkSystem(const Network& network, double accuracy) {
  model_ = make_dimensionless(network, accuracy);
  layout_ = make_layout(model_);
  phase_.reset();
}

}  // namespace mariotte::model
