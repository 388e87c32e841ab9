#include "mariotte/model/network/dimensionless_network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mariotte/model/contacts/scaled_law.hpp"
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

std::size_t quickest_contact(const Network& network, const Numbers& mass, double speed) {
  std::vector<double> length;
  NaturalLength natural_length;
  for (std::size_t j = 0; j < mass.size(); ++j)
    length.push_back(natural_length(network.law[j], mass[j], speed));
  return static_cast<std::size_t>(std::min_element(length.begin(), length.end()) - length.begin());
}

/// By freedom: the contacts that have a term in it.
std::vector<std::vector<Index>> contacts_of(const std::vector<ContactDirection>& terms, Index freedoms) {
  std::vector<std::vector<Index>> contacts(freedoms);
  for (Index j = 0; j < std::ssize(terms); ++j)
    for (const auto& term : terms[j]) contacts[term.freedom].push_back(j);
  return contacts;
}

void find_near(DimensionlessNetwork& d) {
  const auto felt_by = contacts_of(d.direction, d.freedoms);
  d.near.resize(d.push.size());
  for (std::size_t j = 0; j < d.push.size(); ++j) {
    auto& near = d.near[j];
    for (const auto& term : d.push[j])
      near.insert(near.end(), felt_by[term.freedom].begin(), felt_by[term.freedom].end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
}

}  // namespace

DimensionlessNetwork make_dimensionless(const Network& network, double accuracy) {
  DimensionlessNetwork d;
  d.freedoms = std::ssize(network.velocity);
  d.direction = network.direction;
  d.push = push_directions(network.mass, network.direction, d.freedoms);
  d.half_push = half_pushes(network.mass, network.direction, d.freedoms);
  Numbers mass;
  for (std::size_t j = 0; j < d.push.size(); ++j) mass.push_back(1 / dot(d.direction[j], d.push[j]));
  const double speed = reference_speed(network, mass);
  NaturalLength natural_length, slow_length;
  const auto quickest = quickest_contact(network, mass, speed);
  d.scale.mass = power_of_two_below(2 * mass[quickest]);
  d.scale.velocity = power_of_two_below(speed);
  d.scale.length = natural_length(network.law[quickest], d.scale.mass, d.scale.velocity);
  d.scale.time = d.scale.length / d.scale.velocity;
  d.speed = speed / d.scale.velocity;
  d.slow = slow_share(accuracy) * d.speed;
  for (const double v : network.velocity) d.velocity.push_back(v / d.scale.velocity);
  for (auto& push : d.push)
    for (auto& term : push) term.coefficient *= d.scale.mass;
  for (auto& half : d.half_push)
    for (auto& term : half) term.coefficient *= std::sqrt(d.scale.mass);
  for (std::size_t j = 0; j < network.law.size(); ++j) {
    d.law.push_back(scaled(network.law[j], d.scale, network.law[quickest]));
    d.gap.push_back(network.gap[j] / d.scale.length);
    d.reduced_mass.push_back(mass[j] / d.scale.mass);
    d.length.push_back(natural_length(d.law[j], d.reduced_mass[j], d.speed));
    d.time.push_back(d.length[j] / d.speed);
    d.shallow.push_back(slow_length(d.law[j], d.reduced_mass[j], d.slow));
  }
  expect_representable(network, d);
  find_near(d);
  return d;
}

}  // namespace mariotte::model
