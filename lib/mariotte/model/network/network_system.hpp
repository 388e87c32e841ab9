// A network as a hybrid system.
#pragma once
#include "mariotte/model/contacts/contact_system.hpp"
#include "mariotte/model/network/network_layout.hpp"
#include "mariotte/model/network/network_topology.hpp"

namespace mariotte::model {

using NetworkPhase = TopologyPhase<NetworkTopology>;
extern template class TopologyPhase<NetworkTopology>;
extern template class ContactSystem<NetworkTopology>;

/// `network().scale` leads back to the units of the scene. A contact that touches at rest is pressed or drawn
/// apart when a contact near it is pressed.
class NetworkSystem : public ContactSystem<NetworkTopology> {
 public:
  NetworkSystem() = default;
  NetworkSystem(const Network& network, double accuracy, bool stay = false) {
    reset(network, accuracy, stay);
  }
  /// Become the system of another network and reuse the memory. `stay` follows what adhesion holds together
  /// up to the time limit.
  void reset(const Network& network, double accuracy, bool stay = false);
  const DimensionlessNetwork& network() const { return model_; }
};

}  // namespace mariotte::model
