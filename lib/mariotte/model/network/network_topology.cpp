#include "mariotte/model/network/network_topology.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/contacts/phase_contact.hpp"

namespace mariotte::model {
namespace {

double inverse_mass(const ContactDirection& response, Index dof) {
  for (const auto& term : response)
    if (term.dof == dof) return std::abs(term.coefficient);
  return 0;
}

}  // namespace

std::optional<NetworkFlows::Ends> NetworkFlows::ends_of(const DimensionlessNetwork& network, Index j) {
  const auto& terms = network.direction[j];
  if (terms.size() != 2) return std::nullopt;
  const Index left = terms[0].coefficient < 0 ? 0 : 1;
  if (terms[left].coefficient != -1 || terms[1 - left].coefficient != 1) return std::nullopt;
  const Ends ends{terms[left].dof, terms[1 - left].dof};
  for (const auto& term : network.response[j])
    if (term.dof != ends.left && term.dof != ends.right) return std::nullopt;
  return ends;
}

/// True if every contact joins two dofs, and none of them is on the same side of two contacts.
bool NetworkFlows::find_ends(const DimensionlessNetwork& network) {
  ends_.clear();
  starting_.assign(network.dofs, -1);
  ending_.assign(network.dofs, -1);
  for (Index j = 0; j < network.contacts(); ++j) {
    const auto found = ends_of(network, j);
    if (!found || starting_[found->left] >= 0 || ending_[found->right] >= 0) return false;
    starting_[found->left] = ending_[found->right] = j;
    ends_.push_back(*found);
  }
  return true;
}

/// Drives move what is in contacts only: a row has no place for other dofs.
bool NetworkFlows::drives_within(const DimensionlessNetwork& network) const {
  const auto is_joined = [&](const auto& term) { return starting_[term.dof] >= 0 || ending_[term.dof] >= 0; };
  const auto are_joined = [&](const ContactDirection& terms) {
    return std::all_of(terms.begin(), terms.end(), is_joined);
  };
  return std::all_of(network.drive.begin(), network.drive.end(), [&](const auto& drive) {
    return are_joined(drive.direction) && are_joined(drive.response);
  });
}

/// The contacts join bodies of one dof each in a single row: −1 in the left one, +1 in the right one, and
/// nothing else pushed or driven.
void NetworkFlows::find_row(const DimensionlessNetwork& network) {
  row_.clear();
  if (!find_ends(network) || !drives_within(network)) return;
  const Index m = network.contacts();
  Index first = 0;
  while (first < m && ending_[ends_[first].left] >= 0) ++first;
  if (first == m) return;  // a ring
  row_.assign(m, -1);
  Index count = 0;
  for (Index j = first; j >= 0; j = starting_[ends_[j].right]) row_[j] = count++;
  if (count < m) row_.clear();
}

void NetworkFlows::make_serial(const NetworkTopology& topology) {
  const auto& [network, at] = topology;
  serial_.speed = network.speed;
  serial_.reached_speed = network.reached_speed;
  serial_.fade_speed = network.noise_speed;
  serial_.body.resize(row_.size() + 1);
  serial_.contact.resize(row_.size());
  for (Index j = 0; j < std::ssize(row_); ++j) {
    const auto [left, right] = ends_[j];
    serial_.body[row_[j]] = {left, inverse_mass(network.response[j], left), 0};
    serial_.body[row_[j] + 1] = {right, inverse_mass(network.response[j], right), 0};
    serial_.contact[row_[j]] = phase_contact(network, at, j);
  }
}

void NetworkFlows::make_linked(const NetworkTopology& topology) {
  const auto& [network, at] = topology;
  linked_.contact.clear();
  linked_.dofs = network.dofs;
  linked_.direction = network.direction;
  linked_.response = network.response;
  linked_.half_response = network.half_response;
  linked_.speed = network.speed;
  linked_.reached_speed = network.reached_speed;
  linked_.fade_speed = network.fade_speed_ratio * network.noise_speed;
  linked_.coupling.clear();
  for (Index j = 0; j < network.contacts(); ++j) {
    linked_.contact.push_back(phase_contact(network, at, j));
    couple(topology, j);
  }
}

/// Its own contact comes first.
void NetworkFlows::couple(const NetworkTopology& topology, Index j) {
  auto& coupling = linked_.coupling;
  coupling.add(j, -topology.coupling(j, j));
  topology.for_each_near(j, [&](Index i) {
    const double by_force = -topology.coupling(j, i);
    if (i != j && by_force != 0) coupling.add(i, by_force);
  });
  coupling.end_row();
}

void NetworkFlows::reset(const NetworkTopology& network) {
  find_row(network.model);
  row_.empty() ? make_linked(network) : make_serial(network);
}

}  // namespace mariotte::model
