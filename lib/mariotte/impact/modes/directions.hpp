// Contact directions of a network as dense columns.
#pragma once
#include <vector>

#include "mariotte/model/network/network.hpp"

namespace mariotte::impact {

/// Columns of n values, one after the other.
inline std::vector<double> dense(const std::vector<ContactDirection>& columns, Index dofs) {
  std::vector<double> values(static_cast<std::size_t>(dofs * std::ssize(columns)));
  for (Index j = 0; j < std::ssize(columns); ++j)
    for (const auto& [dof, coefficient] : columns[j]) values[j * dofs + dof] = coefficient;
  return values;
}

/// L⁻¹ Gᵀ with M = L Lᵀ, n × m.
inline std::vector<double> half_directions(const model::Network& network) {
  const Index dofs = std::ssize(network.velocity);
  std::vector<ContactDirection> columns;
  model::half_responses(network.mass, network.direction, dofs, columns);
  return dense(columns, dofs);
}

}  // namespace mariotte::impact
