#include "mariotte/model/network/network_system.hpp"

#include "mariotte/model/contacts/topology_phase_members.hpp"

namespace mariotte::model {

template class TopologyPhase<NetworkTopology>;
template class ContactSystem<NetworkTopology>;

void NetworkSystem::reset(const Network& network, double accuracy) {
  make_dimensionless(network, accuracy, model_);
  make_layout(model_, layout_);
  phase_.reset();
}

}  // namespace mariotte::model
