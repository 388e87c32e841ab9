#include "mariotte/model/network/network_topology.hpp"

#include <cmath>
#include <optional>

#include "mariotte/model/contacts/phase_contact.hpp"

namespace mariotte::model {
namespace {

/// The dofs that a contact of a row joins.
struct Ends {
  Index left, right;
};

std::optional<Ends> ends_of(const DimensionlessNetwork& network, Index j) {
  const auto& terms = network.direction[j];
  if (terms.size() != 2) return std::nullopt;
  const Index left = terms[0].coefficient < 0 ? 0 : 1;
  if (terms[left].coefficient != -1 || terms[1 - left].coefficient != 1) return std::nullopt;
  const Ends ends{terms[left].dof, terms[1 - left].dof};
  for (const auto& term : network.response[j])
    if (term.dof != ends.left && term.dof != ends.right) return std::nullopt;
  return ends;
}

double inverse_mass(const ContactDirection& push, Index dof) {
  for (const auto& term : push)
    if (term.dof == dof) return std::abs(term.coefficient);
  return 0;
}

/// By contact, its place from left to right, if the contacts join bodies of one dof each in a single row:
/// −1 in the left one, +1 in the right one, and nothing else pushed. Empty otherwise.
std::vector<Index> places_in_row(const DimensionlessNetwork& network) {
  const Index m = network.contacts();
  std::vector<Index> starts(network.dofs, -1), ending(network.dofs, -1);  // contacts, by dof
  std::vector<Ends> ends;
  for (Index j = 0; j < m; ++j) {
    const auto found = ends_of(network, j);
    if (!found || starts[found->left] >= 0 || ending[found->right] >= 0) return {};
    starts[found->left] = ending[found->right] = j;
    ends.push_back(*found);
  }
  Index first = 0;
  while (first < m && ending[ends[first].left] >= 0) ++first;
  if (first == m) return {};  // a ring
  std::vector<Index> place(m, -1);
  Index count = 0;
  for (Index j = first; j >= 0; j = starts[ends[j].right]) place[j] = count++;
  return count == m ? place : std::vector<Index>{};
}

flow::SerialPhase make_serial(const NetworkTopology& topology, const std::vector<Index>& places) {
  const auto& [network, at] = topology;
  flow::SerialPhase phase;
  phase.speed = network.speed;
  phase.fade_speed = network.noise_speed;
  phase.body.resize(places.size() + 1);
  phase.contact.resize(places.size());
  for (Index j = 0; j < std::ssize(places); ++j) {
    const auto [left, right] = *ends_of(network, j);
    phase.body[places[j]] = {left, inverse_mass(network.response[j], left), 0};
    phase.body[places[j] + 1] = {right, inverse_mass(network.response[j], right), 0};
    phase.contact[places[j]] = phase_contact(network, at, j);
  }
  return phase;
}

flow::LinkedPhase make_linked(const NetworkTopology& topology) {
  const auto& [network, at] = topology;
  flow::LinkedPhase phase{.contact = {},
                          .dofs = network.dofs,
                          .direction = network.direction,
                          .response = network.response,
                          .half_response = network.half_response};
  for (Index j = 0; j < network.contacts(); ++j) phase.contact.push_back(phase_contact(network, at, j));
  return phase;
}

}  // namespace

void NetworkFlows::reset(const NetworkTopology& network) {
  row_ = places_in_row(network.model);
  if (row_.empty())
    linked_ = make_linked(network);
  else
    serial_ = make_serial(network, row_);
}

}  // namespace mariotte::model
