// Chains and networks for the naive simulator.
#pragma once
#include <cmath>
#include <utility>

#include "mariotte/model/network/network.hpp"
#include "support/naive_contacts.hpp"

namespace mariotte::test {

/// ġ_j = v_{j+1} − v_j; walls feel neither forces nor gravity.
inline NaiveContacts naive_contacts(const model::Chain& chain) {
  NaiveContacts contacts{.direction = {},
                         .response = {},
                         .law = chain.law,
                         .gap = chain.gap,
                         .velocity = chain.velocity,
                         .acceleration = {}};
  for (const double mass : chain.mass) contacts.acceleration.push_back(std::isinf(mass) ? 0 : -chain.gravity);
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    const auto left = static_cast<Index>(j);
    contacts.direction.push_back({{left, -1}, {left + 1, 1}});
    contacts.response.push_back({{left, -1 / chain.mass[j]}, {left + 1, 1 / chain.mass[j + 1]}});
  }
  return contacts;
}

/// M⁻¹ y by Gauss's elimination of a full matrix, given by rows, or a diagonal one.
inline std::vector<double> naive_solution(std::vector<double> m, std::vector<double> y) {
  const auto n = y.size();
  if (m.size() == n) {
    for (std::size_t i = 0; i < n; ++i) y[i] /= m[i];
    return y;
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = m[n * i + k] / m[n * k + k];
      for (std::size_t j = k; j < n; ++j) m[n * i + j] -= factor * m[n * k + j];
      y[i] -= factor * y[k];
    }
  for (std::size_t i = 0; i < n; ++i) y[i] /= m[n * i + i];
  return y;
}

/// M v̇ = Gᵀ f.
inline NaiveContacts naive_contacts(const model::Network& network) {
  const auto n = network.velocity.size();
  NaiveContacts contacts{.direction = network.direction,
                         .response = {},
                         .law = network.law,
                         .gap = network.gap,
                         .velocity = network.velocity,
                         .acceleration = std::vector<double>(n)};
  for (const auto& direction : network.direction) {
    std::vector<double> row(n);
    for (const auto& [i, coefficient] : direction) row[static_cast<std::size_t>(i)] += coefficient;
    const auto column = naive_solution(network.mass, row);
    auto& push = contacts.response.emplace_back();
    for (std::size_t i = 0; i < n; ++i)
      if (column[i] != 0) push.push_back({static_cast<Index>(i), column[i]});
  }
  return contacts;
}

}  // namespace mariotte::test
