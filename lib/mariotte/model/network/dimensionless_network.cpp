#include "mariotte/model/network/dimensionless_network.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/representable.hpp"

namespace mariotte::model {
namespace {

using Numbers = std::vector<double>;

double reference_speed(const Network& network, const Numbers& mass) {
  double squared = 0;
  for (const auto& direction : network.direction) {
    const double rate = gap_rate(direction, network.velocity);
    squared = std::max(squared, rate * rate);
  }
  for (std::size_t j = 0; j < mass.size(); ++j)
    if (network.gap[j] < 0) squared += 2 * contact::stored_energy(network.law[j], -network.gap[j]) / mass[j];
  return squared > 0 ? std::sqrt(squared) : 1;
}

/// By dof: the contacts that have a term in it.
std::vector<std::vector<Index>> contacts_of(const std::vector<ContactDirection>& terms, Index dofs) {
  std::vector<std::vector<Index>> contacts(dofs);
  for (Index j = 0; j < std::ssize(terms); ++j)
    for (const auto& term : terms[j]) contacts[term.dof].push_back(j);
  return contacts;
}

void find_near(DimensionlessNetwork& d) {
  const auto felt_by = contacts_of(d.direction, d.dofs);
  d.near.resize(d.response.size());
  for (std::size_t j = 0; j < d.response.size(); ++j) {
    auto& near = d.near[j];
    for (const auto& term : d.response[j])
      near.insert(near.end(), felt_by[term.dof].begin(), felt_by[term.dof].end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
}

}  // namespace

DimensionlessNetwork make_dimensionless(const Network& network, double accuracy) {
  DimensionlessNetwork d;
  d.dofs = std::ssize(network.velocity);
  d.direction = network.direction;
  d.response = responses(network.mass, network.direction, d.dofs);
  d.half_response = half_responses(network.mass, network.direction, d.dofs);
  for (std::size_t j = 0; j < d.response.size(); ++j)
    d.reduced_mass.push_back(1 / dot(d.direction[j], d.response[j]));
  scale_contacts({network.law, network.gap, network.velocity}, reference_speed(network, d.reduced_mass),
                 accuracy, d);
  for (auto& push : d.response)
    for (auto& term : push) term.coefficient *= d.scale.mass;
  for (auto& half : d.half_response)
    for (auto& term : half) term.coefficient *= std::sqrt(d.scale.mass);
  expect_representable(network, d);
  find_near(d);
  return d;
}

}  // namespace mariotte::model
