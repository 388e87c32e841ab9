#include "mariotte/model/chain/chain_topology.hpp"

#include "mariotte/model/contacts/phase_contact.hpp"

namespace mariotte::model {

void ChainFlows::reset(const ChainTopology& chain) {
  const auto& [model, at] = chain;
  serial_.body.clear();
  serial_.contact.clear();
  serial_.speed = model.speed;
  serial_.reached_speed = model.reached_speed;
  serial_.fade_speed = model.fade_speed_ratio * model.noise_speed;
  for (Index i = 0; i < at.velocities(); ++i)
    serial_.body.push_back({at.velocity[i], model.inverse_mass[i], -model.gravity[i]});
  for (Index j = 0; j < at.contacts(); ++j) serial_.contact.push_back(phase_contact(model, at, j));
}

void ChainFlows::set_edges(SliceEdges edges) {
  edges_ = edges;
  serial_.is_slice = edges.left || edges.right;
}

bool ChainFlows::is_at_edge(Index j) const {
  return (edges_.left && j < edges_.margin) ||
         (edges_.right && j >= std::ssize(serial_.contact) - edges_.margin);
}

}  // namespace mariotte::model
