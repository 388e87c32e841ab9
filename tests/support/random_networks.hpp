// Random contact networks: always the same ones.
#pragma once
#include <random>

#include "mariotte/model/network/network.hpp"
#include "support/random_configurations.hpp"

namespace mariotte::test {

/// A random network of few contacts that can all open at once, along a common velocity: none is trapped. Half
/// of the gaps are zero; `law(random, j)` is that of contact j.
template <class LawOfContact>
model::Network random_network(std::mt19937_64& random, LawOfContact&& law) {
  const auto c = random_configuration(random);
  model::Network network{
      .mass = c.mass, .direction = c.contact, .law = {}, .gap = {}, .velocity = c.velocity};
  std::uniform_real_distribution<double> unit(0, 1);
  const std::vector<double> apart(c.velocity.size(), 1.0);
  for (auto& direction : network.direction)
    if (gap_rate(direction, apart) < 0)
      for (auto& term : direction) term.coefficient = -term.coefficient;
  for (std::size_t j = 0; j < c.contact.size(); ++j) {
    network.gap.push_back(unit(random) < 0.5 ? 0 : 0.1 * unit(random));
    network.law.push_back(law(random, j));
  }
  return network;
}

}  // namespace mariotte::test
